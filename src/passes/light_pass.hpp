#pragma once
#include "screen_lists.hpp"

namespace prelight::passes {

/// All lights of a frame into the target, in the way that resident::ViewSettings::culling says
/// (`light-culling=`). `name` is the pass's name in figures and labels.
void light_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                const LightingInputs& inputs);

/// All lights of edge pixels' samples into `target`, a sample light buffer, by the lists of `inputs`, or one by one
/// where it has none. `inputs`: as of light_pass(), but for surface and target.
void sample_light_pass(graph::FrameGraph& graph, const resident::View& view, const std::string& name,
                       LightingInputs inputs, const SampledSurfaces& surfaces, const LightTarget& target);

/// The same, but instead of light an image of the lights that each pixel evaluates in R and those that
/// contribute in G, for --view light-count.
graph::ImageId light_count_pass(graph::FrameGraph& graph, const resident::View& view, LightingInputs inputs);

/// How often a light pass may add to one pixel by blending. `one_by_one`: where lights are drawn light by light, they
/// are blended.
uint32_t light_adds(const resident::View& view, bool one_by_one);

} // namespace prelight::passes
