#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// All lights into the target, light by light: full-screen triangles [V1], spheres and cones with
/// depth test by camera position [V3], instanced [V5].
void light_volume_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                       const LightingInputs& inputs);

} // namespace prelight::passes
