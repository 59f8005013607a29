#include "gbuffer.hpp"
#include "fullscreen.hpp"
#include "surface_draws.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// Four bytes each for RT0 … RT3, depth and stencil: Valient's layout.
void make_killzone2(graph::FrameGraph& graph, const gpu::Raster& raster, bool, bool, GBuffer& out) {
    out.surface.format.normals = NormalEncoding::xy16f;
    out.surface.format.view_space = true;
    out.surface.format.stencil = true;
    out.surface.depth = graph.image("depth", raster, {VK_FORMAT_D24_UNORM_S8_UINT, VK_FORMAT_D32_SFLOAT_S8_UINT});
    out.surface.normal = graph.image("normal", {VK_FORMAT_R16G16_SFLOAT, raster});
    out.motion = graph.image("motion and specular", {VK_FORMAT_R8G8B8A8_UNORM, raster});
    out.albedo = graph.image("albedo", {VK_FORMAT_R8G8B8A8_UNORM, raster});
    out.surface.roughness = out.motion;
}

/// Some material dims what it reflects.
bool has_gloss(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
        return material.shader && material.textures.contains("gloss_map");
    });
}

/// What the lighting model needs to be exact.
void make_wide(graph::FrameGraph& graph, const gpu::Raster& raster, bool stencil, bool gloss, GBuffer& out) {
    out.surface.format.stencil = stencil;
    out.surface.depth = make_depth(graph, raster, stencil);
    out.surface.normal = graph.image("normal", {VK_FORMAT_R8G8B8A8_UNORM, raster});
    out.motion = graph.image("motion", {gloss ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R16G16_SFLOAT, raster});
    out.albedo = graph.image("albedo", {VK_FORMAT_R16G16B16A16_SFLOAT, raster});
    out.surface.roughness = out.surface.normal;
}

} // namespace

std::vector<graph::ImageId> GBuffer::targets() const {
    std::vector<graph::ImageId> all{light, surface.normal, motion, albedo};
    if (ambient_apart)
        all.insert(all.end(), {ambient, mirrored});
    return all;
}

GBuffer gbuffer_pass(graph::FrameGraph& graph, const resident::View& view, const GBufferFormat& format) {
    GBuffer out{};
    out.surface.format.gbuffer = format.layout;
    out.surface.format.position_from_ray = format.position_from_ray;
    out.surface.format.specular_antialiasing = format.specular_antialiasing;
    const auto reduced = [&](uint32_t size) { return (size + format.reduction - 1) / format.reduction; };
    const auto [width, height] = view.raster().extent;
    const gpu::Raster raster{{reduced(width), reduced(height)}, format.samples};
    const auto make = format.layout == GBufferLayout::killzone2 ? make_killzone2 : make_wide;
    make(graph, raster, format.stencil, has_gloss(*view.scene().world().scene), out);
    out.surface.depth_source = out.surface.depth;
    const VkFormat light = format.light_in_bytes ? VK_FORMAT_R8G8B8A8_UNORM
                           : format.wide_light   ? VK_FORMAT_R32G32B32A32_SFLOAT
                                                 : VK_FORMAT_R16G16B16A16_SFLOAT;
    out.light = graph.image("accumulated light", {light, raster});

    out.ambient_apart = format.ambient_apart;
    if (format.ambient_apart) {
        if (view.context().limits().maxColorAttachments < 6)
            throw Error(fmt::format("{}: ambient light apart needs 6 colour attachments, and the device has {}",
                                    view.context().name(), view.context().limits().maxColorAttachments));
        out.ambient = graph.image("ambient light", {VK_FORMAT_R16G16B16A16_SFLOAT, raster});
        out.mirrored = graph.image("mirrored light", {VK_FORMAT_R16G16B16A16_SFLOAT, raster});
    }
    graph::Pass& pass = graph.pass(format.pass);
    pass.depth_write(out.surface.depth);
    for (const graph::ImageId target : out.targets())
        pass.colour(target, graph::Load::clear);
    draw_surfaces(graph, pass, view,
                  {.name = pass.name(),
                   .fragment = out.fragment(),
                   .constants = out.surface.format.constants(),
                   .vertex = gpu::Variant::motion});
    return out;
}

void ambient_light_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                        graph::ImageId visibility) {
    graph::Pass& pass = graph.pass("ambient light");
    pass.colour(gbuffer.light, graph::Load::keep)
        .blends()
        .sample(INPUT_DEPTH, gbuffer.surface.depth_source)
        .sample(INPUT_NORMAL, gbuffer.surface.normal)
        .sample(INPUT_OCCLUSION, visibility)
        .sample(INPUT_AMBIENT_LIGHT, gbuffer.ambient)
        .sample(INPUT_MIRRORED_LIGHT, gbuffer.mirrored);
    draw_fullscreen(pass, view, "ambient_light.frag", gbuffer.surface.format.constants(), gpu::Blend::add);
}

graph::ImageId light_resolve_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                                  Display display, const SampleColours* samples) {
    const graph::ImageId target =
        picture_image(graph, view, samples ? samples->raster : graph.raster(gbuffer.light), display);
    graph::Pass& pass = graph.pass("resolve");
    pass.colour(target, graph::Load::discard).sample(INPUT_COLOUR, gbuffer.light);
    if (samples)
        pass.sample(INPUT_EDGE_FLAGS, samples->edges.flags).sample(INPUT_SAMPLE_DIFFUSE, samples->light);
    const bool bytes = graph.desc(gbuffer.light).format == VK_FORMAT_R8G8B8A8_UNORM;
    gpu::Constants constants = display_constants(display, graph.desc(target).format);
    constants.emplace_back(CONSTANT_CLIPPED_LIGHT, bytes);
    if (samples)
        for (const auto& constant : samples->edges.constants())
            constants.push_back(constant);
    draw_fullscreen(pass, view, {"light_resolve.frag", gpu::when(samples, gpu::Variant::sample_light)}, constants);
    return target;
}

} // namespace prelight::passes
