#pragma once
#include "gbuffer.hpp"

namespace prelight::passes {

/// `linear` (scene-linear, background drawn) as a shutter sees it that was open from the moment's previous state until
/// now, by the G-buffer's motion vectors. What moves more than MOTION_TILE pixels is blurred over as many.
graph::ImageId motion_blur_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                                graph::ImageId linear);

} // namespace prelight::passes
