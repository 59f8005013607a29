#pragma once
#include "settings.hpp"
#include <resident/shadow_plan.hpp>

namespace prelight {

/// The settings of every architecture that say whether lights have shadows, and how: [S1] [S2].
std::vector<SettingInfo> shadow_settings();
/// What they say; no shadows where a renderer has none of them.
resident::ShadowOptions shadow_options(const Settings& settings);

} // namespace prelight
