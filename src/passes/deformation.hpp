#pragma once
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// Makes the vertices of skins and morph targets, and those of the previous state, before anything is drawn with them,
/// in frames whose shapes are others than those of the frame before.
void deformation_pass(graph::FrameGraph& graph, const resident::View& view);

} // namespace prelight::passes
