#include "depth_only.hpp"
#include "depth_normal.hpp"
#include "hidden_geometry.hpp"
#include "surface_draws.hpp"

namespace prelight::passes {

graph::ImageId depth_only_pass(graph::FrameGraph& graph, const resident::Frame& frame, bool stencil) {
    const graph::ImageId depth = make_depth(graph, frame.extent(), stencil);
    graph::Pass& pass = graph.pass("depth");
    pass.depth_write(depth);
    draw_surfaces(graph, pass, frame,
                  {.name = "depth", .fragment = "depth_mask.frag", .constants = {}, .depth_only = true});
    hidden_geometry_passes(graph, frame, depth);
    return depth;
}

} // namespace prelight::passes
