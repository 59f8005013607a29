#include "depth_normal.hpp"
#include "surface_draws.hpp"
#include <shared/bindings.h>

namespace prelight::passes {
namespace {

/// The target of each encoding, and what takes its place on a device that cannot draw into it: the
/// shaders write and read the same 0 … 1 values whatever the format.
graph::ImageId normal_target(graph::FrameGraph& graph, VkExtent2D extent, NormalEncoding encoding) {
    switch (encoding) {
    case NormalEncoding::oct24: return graph.image("normal", {VK_FORMAT_R8G8B8A8_UNORM, extent});
    case NormalEncoding::oct32:
        return graph.image("normal", extent, {VK_FORMAT_R16G16_UNORM, VK_FORMAT_R32G32_SFLOAT});
    case NormalEncoding::rgb10a2: break;
    }
    return graph.image("normal", extent, {VK_FORMAT_A2B10G10R10_UNORM_PACK32, VK_FORMAT_R8G8B8A8_UNORM});
}

} // namespace

gpu::Constants SurfaceFormat::constants() const {
    return {{CONSTANT_NORMAL_ENCODING, static_cast<uint32_t>(normals)},
            {CONSTANT_NORMAL_SPACE, view_space},
            {CONSTANT_LINEAR_DEPTH, linear_depth},
            {CONSTANT_POSITION_FROM_RAY, position_from_ray}};
}

graph::ImageId make_depth(graph::FrameGraph& graph, VkExtent2D extent, bool stencil) {
    return stencil ? graph.image("depth", extent, {VK_FORMAT_D32_SFLOAT_S8_UINT, VK_FORMAT_D24_UNORM_S8_UINT})
                   : graph.image("depth", {VK_FORMAT_D32_SFLOAT, extent});
}

SurfaceBuffers depth_normal_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                                 const SurfaceFormat& format) {
    const VkExtent2D extent = frame.extent();
    SurfaceBuffers out{format};
    out.depth = out.depth_source = make_depth(graph, extent, format.stencil);
    out.normal = out.roughness = normal_target(graph, extent, format.normals);

    std::string shader = "depth_normal";
    graph::Pass& pass = graph.pass("depth-normal");
    pass.depth_write(out.depth).colour(out.normal, graph::Load::clear);
    if (format.normals != NormalEncoding::oct24) {
        out.roughness = graph.image("roughness", {VK_FORMAT_R16_SFLOAT, extent});
        pass.colour(out.roughness, graph::Load::clear);
        shader += "+roughness";
    }
    if (format.linear_depth) {
        out.depth_source = graph.image("linear depth", extent, {VK_FORMAT_R32_SFLOAT, VK_FORMAT_R16_SFLOAT});
        pass.colour(out.depth_source, graph::Load::clear);
        shader += "+depth";
    }
    draw_surfaces(pass, frame,
                  {.name = "depth-normal", .fragment = shader + ".frag", .constants = format.constants()});
    return out;
}

} // namespace prelight::passes
