#include "depth_only.hpp"
#include "depth_normal.hpp"
#include "hidden_geometry.hpp"
#include "surface_draws.hpp"

namespace prelight::passes {

graph::ImageId depth_only_pass(graph::FrameGraph& graph, const resident::View& view, bool stencil) {
    const graph::ImageId depth = make_depth(graph, view.raster(), stencil);
    graph::Pass& pass = graph.pass("depth");
    pass.depth_write(depth);
    draw_surfaces(graph, pass, view,
                  {.name = "depth", .fragment = "depth_mask.frag", .constants = {}, .depth_only = true});
    hidden_geometry_passes(graph, view, depth);
    return depth;
}

} // namespace prelight::passes
