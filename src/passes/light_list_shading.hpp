#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// All lights into the target by `inputs.lists`, of tiles of the screen or of depth slices of tiles:
/// each pixel sums its lights in registers and is written once.
void light_list_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                     const LightingInputs& inputs);

} // namespace prelight::passes
