#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// The lights of each tile by a compute pass that writes the target as storage images, once a pixel: each
/// invocation of a subgroup loads another light and hands it to its neighbours. Ambient light, if it is
/// one, is summed with the others.
void light_list_compute_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                             const LightingInputs& inputs, const LightListRound& round);

} // namespace prelight::passes
