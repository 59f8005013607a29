#pragma once
#include "light_lists.hpp"
#include "lighting.hpp"

namespace prelight::passes {

/// `inputs.list_shading` as the device and the other inputs have it, never automatic. A note in the graph says why
/// what was asked for cannot be had.
ListShading list_shading_of(graph::FrameGraph& graph, const resident::Frame& frame, const LightingInputs& inputs);

/// True where the light buffer should be one image of pairs (make_light_buffer()): a software device with such a pass,
/// and the model's light buffer is a pair of RGBA16F.
bool light_pair_pays(const resident::Frame& frame, const LightModel& model, ListShading asked);

/// The lights of each tile by a compute pass that writes the target as storage images, once a pixel: each
/// invocation of a subgroup loads another light and hands it to its neighbours. Ambient light, if it is
/// one, is summed with the others. `everywhere`: pixels without light are written too. `ending`: of the passes' names.
void light_list_compute_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                             const LightingInputs& inputs, const LightLists& lists, bool everywhere,
                             const std::string& ending);

} // namespace prelight::passes
