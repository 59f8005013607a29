#pragma once
#include <prelight/device.hpp>
#include <string>

namespace prelight::app {

/// As DeviceInfo::type says it; "other" for a device that is not listed.
std::string type_of(const Device& device);

} // namespace prelight::app
