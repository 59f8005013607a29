#include "depth_only.hpp"
#include "surface_draws.hpp"

namespace prelight::passes {

graph::ImageId depth_only_pass(graph::FrameGraph& graph, const resident::Frame& frame) {
    const graph::ImageId depth = graph.image("depth", {VK_FORMAT_D32_SFLOAT, frame.extent()});
    graph::Pass& pass = graph.pass("depth");
    pass.depth_write(depth);
    draw_surfaces(pass, frame, {.name = "depth", .fragment = "depth_mask.frag", .constants = {}, .depth_only = true});
    return depth;
}

} // namespace prelight::passes
