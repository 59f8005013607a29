#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// All lights of a frame into the target, in the way that resident::FrameSettings::culling says
/// (`light-culling=`): [V1] … [V7]. `name` is the pass's name in figures and labels.
void light_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                const LightingInputs& inputs);

/// The setting `light-culling` of every architecture with light passes.
SettingInfo light_culling_setting();
resident::LightCulling light_culling(const std::string& value);

} // namespace prelight::passes
