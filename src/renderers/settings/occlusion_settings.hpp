#pragma once
#include "settings.hpp"
#include <passes/ambient_occlusion.hpp>

namespace prelight {

/// Settings of renderers that have depth and normals before ambient light comes in (docs/ssao.md).
std::vector<SettingInfo> occlusion_settings();
passes::OcclusionOptions occlusion_options(const Settings& settings);

} // namespace prelight
