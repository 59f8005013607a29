#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// All lights into the target, light by light: full-screen triangles, spheres and cones with
/// depth test by camera position, instanced.
void light_volume_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                       const LightingInputs& inputs);

} // namespace prelight::passes
