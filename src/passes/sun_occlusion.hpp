#pragma once
#include "gbuffer.hpp"

namespace prelight::passes {

/// Valient's sun occlusion: how much of the first directional light that has shadow maps comes to each pixel, in the
/// alpha of RT3 of GBufferLayout::killzone2. Returns `shadows` with sun_stored: light passes read it there, and filter
/// that light's maps no more. Where a frame has no such light the channel stays as the geometry pass left it. Nothing
/// without shadows.
Shadows sun_occlusion_pass(graph::FrameGraph& graph, const resident::View& view, const GBuffer& gbuffer,
                           Shadows shadows);

} // namespace prelight::passes
