#pragma once
#include "settings.hpp"
#include <resident/shadow_plan.hpp>

namespace prelight {

/// The settings of every architecture that say whether lights have shadows, and how.
/// `light_by_light`: its light passes may draw one light after the other.
std::vector<SettingInfo> shadow_settings(bool light_by_light = false);
/// Where maps of one light after the other share their memory, lights are drawn one by one: chooses
/// light-culling=volumes where it is still `auto`. Throws UsageError for light culling that reads all maps at
/// once, but lets a preset's value give way to them, with a note.
void choose_shadow_memory(Settings& settings);
/// What they say; no shadows where a renderer has none of them.
resident::ShadowOptions shadow_options(const Settings& settings);

} // namespace prelight
