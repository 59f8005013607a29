#include "edge_blur.hpp"
#include "fullscreen.hpp"
#include "tonemap.hpp"

namespace prelight::passes {

gpu::Constants read_geometry_edges(graph::Pass& pass, const SurfaceBuffers& surface, VkFormat picture) {
    pass.sample(INPUT_DEPTH, surface.depth_source).sample(INPUT_NORMAL, surface.normal);
    gpu::Constants constants = surface.format.constants();
    for (const auto& more : display_constants({}, picture))
        constants.push_back(more);
    constants.emplace_back(CONSTANT_HAS_NORMALS, surface.normal != surface.depth);
    return constants;
}

graph::ImageId edge_blur_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface,
                              graph::ImageId picture) {
    const graph::ImageId blurred = graph.image("edge-blurred", graph.desc(picture));
    graph::Pass& pass = graph.pass("edge-blur");
    pass.colour(blurred, graph::Load::discard).sample(INPUT_COLOUR_BEFORE, picture);
    draw_fullscreen(pass, view, "edge_blur.frag", read_geometry_edges(pass, surface, graph.desc(picture).format));
    return blurred;
}

} // namespace prelight::passes
