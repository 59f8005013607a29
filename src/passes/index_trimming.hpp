#pragma once
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// With index-trimming=device: leaves out triangles that face away, lie off screen or cover no pixel's centre, of
/// each visible object, in the order in which they stand. Comes before every pass over the geometry.
void index_trimming_passes(graph::FrameGraph& graph, const resident::View& view);

/// With material-trimming=depth: leaves out triangles of a few pixels that lie behind what `depth` holds at each of
/// them, for the passes that come after the first. Whatever trimmed indices before is the source.
void depth_trimming_passes(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth);

} // namespace prelight::passes
