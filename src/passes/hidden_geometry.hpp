#pragma once
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// Between the first pass over the geometry, which left `depth`, and the later ones: what lets them leave out draws
/// and triangles of which no pixel is left, as the frame's DrawOptions have it. Nothing without.
void hidden_geometry_passes(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth);

} // namespace prelight::passes
