#pragma once
#include "settings.hpp"

namespace prelight {

/// What smooths the edges of the finished picture (docs/anti-aliasing.md).
enum class Antialiasing { none, edge_blur, smaa };

/// `antialiasing`, of every renderer on a device.
SettingInfo antialiasing_setting();
/// What it says; none where a renderer does not have it.
Antialiasing antialiasing(const Settings& settings);

} // namespace prelight
