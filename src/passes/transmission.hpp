#pragma once
#include "blended.hpp"

namespace prelight::passes {

/// Draws objects that are resident::Draw::transmissive() over what `inputs.colour` holds, which is scene-linear, and
/// which they show: docs/transmission.md. Of several at a place the nearest one is seen. Passes: "behind …",
/// "transmission depth" with "transmission surfaces" (a copy of `inputs.depth` with them in it), and "transmission".
/// `inputs`: as of blended_pass(). Returns that depth, for what is drawn after them.
graph::ImageId transmission_passes(graph::FrameGraph& graph, const resident::View& view, ForwardInputs inputs,
                                   const BlendedLights& lights);

} // namespace prelight::passes
