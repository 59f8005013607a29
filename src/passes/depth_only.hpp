#pragma once
#include "depth_normal.hpp"
#include <graph/frame_graph.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

/// Depth of the nearest surface and nothing else; the alpha mask is honoured. Reversed; D32F, or with
/// `stencil` beside it as make_depth() has it.
graph::ImageId depth_only_pass(graph::FrameGraph& graph, const resident::View& view, bool stencil = false);

/// The same as surfaces of which nobody reads more than depth.
SurfaceBuffers depth_only_surfaces(graph::FrameGraph& graph, const resident::View& view);

/// The same at the centres of pixels, "pixel depth", where surfaces have several samples: for views.
graph::ImageId pixel_depth_pass(graph::FrameGraph& graph, const resident::View& view);

} // namespace prelight::passes
