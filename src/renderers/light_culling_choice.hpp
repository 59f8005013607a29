#pragma once
#include "settings.hpp"

namespace prelight {

class Device;

/// Replaces light-culling=auto by what is fastest on the device (docs/performance.md has the figures): tiles where
/// lists can be built; else, or where lights shall be blended one by one, volumes.
void choose_light_culling(Settings& settings, const Device& device);

} // namespace prelight
