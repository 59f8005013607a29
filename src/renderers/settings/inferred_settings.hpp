#pragma once
#include "settings.hpp"
#include <vulkan/vulkan_core.h>

namespace prelight {

/// The resolution of the light, as a share of the picture's; whether blended surfaces are layers in it.
std::vector<SettingInfo> inferred_settings();
/// ⌈frame × scale⌉.
VkExtent2D inferred_extent(const Settings& settings, VkExtent2D frame);
bool has_layers(const Settings& settings);

} // namespace prelight
