#pragma once
#include "light_lists.hpp"
#include "lighting.hpp"

namespace prelight::passes {

/// `inputs.list_shading` as the device and the other inputs have it, never automatic. A note in the graph says why
/// what was asked for cannot be had.
ListShading list_shading_of(graph::FrameGraph& graph, const resident::Frame& frame, const LightingInputs& inputs);

/// The lights of each tile by a compute pass that writes the target as storage images, once a pixel: each
/// invocation of a subgroup loads another light and hands it to its neighbours. Ambient light, if it is
/// one, is summed with the others.
void light_list_compute_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                             const LightingInputs& inputs, const LightLists& lists);

} // namespace prelight::passes
