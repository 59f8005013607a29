#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// All lights into the target, each in two draws: the faces of its volume count in stencil around
/// which surfaces they close, then its back faces light what is marked and zero it again. The surface's
/// depth image must have stencil (SurfaceFormat::stencil).
void light_stencil_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                        const LightingInputs& inputs);

} // namespace prelight::passes
