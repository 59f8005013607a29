#pragma once
#include <graph/frame_graph.hpp>
#include <resident/frame.hpp>

namespace prelight::passes {

/// [E4] Scene-linear `colour` → sRGB-encoded RGBA8.
graph::ImageId tonemap_pass(graph::FrameGraph& graph, const resident::Frame& frame,
                            graph::ImageId colour, Tonemap curve);

} // namespace prelight::passes
