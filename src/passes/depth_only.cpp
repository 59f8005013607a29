#include "depth_only.hpp"
#include "depth_normal.hpp"
#include "hidden_geometry.hpp"
#include "surface_draws.hpp"

namespace prelight::passes {
namespace {

void draw_depth(graph::FrameGraph& graph, const resident::View& view, const char* name, graph::ImageId depth) {
    graph::Pass& pass = graph.pass(name);
    pass.depth_write(depth);
    draw_surfaces(graph, pass, view,
                  {.name = name, .fragment = "depth_mask.frag", .constants = {}, .depth_only = true});
}

} // namespace

graph::ImageId pixel_depth_pass(graph::FrameGraph& graph, const resident::View& view) {
    const graph::ImageId depth = make_depth(graph, view.raster(), false);
    draw_depth(graph, view, "pixel depth", depth);
    return depth;
}

graph::ImageId depth_only_pass(graph::FrameGraph& graph, const resident::View& view, bool stencil) {
    const graph::ImageId depth = make_depth(graph, view.surface_raster(), stencil);
    draw_depth(graph, view, "depth", depth);
    hidden_geometry_passes(graph, view, depth);
    return depth;
}

SurfaceBuffers depth_only_surfaces(graph::FrameGraph& graph, const resident::View& view) {
    const graph::ImageId depth = depth_only_pass(graph, view);
    return {.format = {}, .depth = depth, .depth_source = depth, .normal = depth, .roughness = depth};
}

} // namespace prelight::passes
