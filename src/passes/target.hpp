#pragma once
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// Whether a target's format is one that the pass writes.
bool is_target_format(VkFormat format);
/// Adds a pass that writes `buffer`, a finished picture, into the graph's external image, of this format: values as
/// read() gives them, but for display-encoded ones in a format that encodes by itself.
void target_pass(graph::FrameGraph& graph, const resident::View& view, graph::ImageId buffer, VkFormat format);

} // namespace prelight::passes
