#pragma once
#include "settings.hpp"
#include <passes/screen_lists.hpp>

namespace prelight {

class Device;

/// `light-culling`, of every architecture with light passes, and how its lists are made and walked.
std::vector<SettingInfo> light_culling_settings();
/// Of rectangles, volumes and stencil.
std::vector<SettingInfo> volume_settings();

/// Replaces light-culling=auto by what is fastest on the device (docs/performance.md has the figures): tiles where
/// lists can be built; else, or where lights shall be blended one by one, volumes.
void choose_light_culling(Settings& settings, const Device& device);

/// What the resolved settings say.
resident::LightCulling light_culling(const Settings& settings);
passes::ScreenListOptions screen_list_options(const Settings& settings);
resident::VolumeOptions volume_options(const Settings& settings);

} // namespace prelight
