#pragma once
#include "device_selection.hpp"
#include <prelight/vulkan.hpp>

namespace prelight::gpu {

/// What a device with these optional features is made with: them, and what Prelight needs of any.
vulkan::DeviceFeatures features_to_enable(const OptionalFeatures& optional);
/// Takes out of `optional` what a device was made without. Gives what it lacks that Prelight needs, by name; empty: it
/// has all.
std::string keep_enabled(OptionalFeatures& optional, const vulkan::DeviceFeatures& enabled);

} // namespace prelight::gpu
