#pragma once
#include "light_lists.hpp"
#include "lighting.hpp"

namespace prelight::passes {

/// Whether light lists are walked by light_list_compute_pass(), as `inputs.list_shading` and the device have
/// it. A note in the graph says why compute was asked for and cannot be had.
bool takes_compute(graph::FrameGraph& graph, const resident::Frame& frame, const LightingInputs& inputs);

/// The lights of each tile by a compute pass that writes the target as storage images, once a pixel: each
/// invocation of a subgroup loads another light and hands it to its neighbours. Ambient light, if it is
/// one, is summed with the others.
void light_list_compute_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                             const LightingInputs& inputs, const LightLists& lists);

} // namespace prelight::passes
