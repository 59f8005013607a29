#pragma once
#include <graph/frame_graph.hpp>
#include <resident/frame.hpp>

namespace prelight::passes {

/// [Z1] Depth of the nearest surface and nothing else; the alpha mask is honoured. D32F, reversed.
graph::ImageId depth_only_pass(graph::FrameGraph& graph, const resident::Frame& frame);

} // namespace prelight::passes
