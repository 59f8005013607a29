#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// All lights into the target, each by the rectangle that its volume covers on the screen. The
/// rectangle lies at the volume's near side and finds surfaces behind it, or, when the camera is inside,
/// at its far side and finds surfaces before it: one draw for all lights of a kind. With the depth
/// bounds test both sides count, at one draw a light.
void light_rectangle_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                          const LightingInputs& inputs);

} // namespace prelight::passes
