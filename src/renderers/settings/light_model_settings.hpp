#pragma once
#include "settings.hpp"
#include <passes/light_model.hpp>

namespace prelight {

/// The settings of light buffers and of what is summed in them.
std::vector<SettingInfo> light_model_settings();
/// Settings that renderers with and without a light buffer have.
SettingInfo specular_gate_setting();
SettingInfo specular_vector_setting();
/// `model`, of renderers where each light meets its surface's material.
SettingInfo model_setting();
/// What those three say.
passes::LightModel material_light_model(const Settings& settings);
/// What blended surfaces are shaded with: they meet each light where they are drawn, and know no light buffer.
passes::LightModel blended_light_model(const Settings& settings);
/// The model that the settings ask for. What they leave open ("auto", defaults that do not go with
/// what the user asked for) is resolved in `settings`. Throws UsageError for what does not go together.
passes::LightModel light_model(Settings& settings, Shading shading);

} // namespace prelight
