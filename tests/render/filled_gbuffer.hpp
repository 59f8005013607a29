#pragma once
#include "against_reference.hpp"
#include <gpu/world_view.hpp>
#include <passes/deformation.hpp>
#include <passes/gbuffer.hpp>

namespace prelight {

inline Shot deferred(Shot shot, std::map<std::string, std::string> settings = {}) {
    shot.renderer = "deferred";
    shot.settings = std::move(settings);
    return shot;
}

inline Image picture_of(const Shot& shot) { return render_linear(test_device(), shot); }

/// A G-buffer of its own, filled once; its texels can be read.
struct FilledGBuffer {
    const gpu::Context& context = dynamic_cast<gpu::Context&>(test_device());
    WorldView on_device;
    resident::View& view = on_device.view;
    graph::FrameGraph graph{context};
    passes::GBuffer buffer;

    FilledGBuffer(const Shot& shot, const passes::GBufferFormat& format)
        : on_device(context, *shot.world, {.raster = {{shot.width, shot.height}}, .light_scale = 2}, {.motion = true}) {
        passes::deformation_pass(graph, view);
        buffer = passes::gbuffer_pass(graph, view, format);
        for (const graph::ImageId image :
             {buffer.light, buffer.surface.normal, buffer.motion, buffer.albedo, buffer.surface.depth})
            graph.keep(image);
        graph.compile();
        view.update(shot.camera);
        context.run("G-buffer", [&](VkCommandBuffer commands) { graph.record(commands); });
    }
    VkFormat format(graph::ImageId image) const { return graph.desc(image).format; }
    /// Four channels of 8 bits.
    glm::dvec4 bytes(graph::ImageId image, uint32_t x, uint32_t y) const {
        const auto texels = graph.read_back(image);
        glm::dvec4 value{0};
        for (int c = 0; c < 4; ++c)
            value[c] =
                std::to_integer<int>(texels[4 * (size_t(y) * view.raster().extent.width + x) + size_t(c)]) / 255.0;
        return value;
    }
};

inline constexpr passes::GBufferFormat killzone2{.layout = passes::GBufferLayout::killzone2, .light_in_bytes = true};

} // namespace prelight
