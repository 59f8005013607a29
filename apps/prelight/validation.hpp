#pragma once
#include <prelight/device.hpp>

namespace prelight::app {

/// Throws Error when validation had something to say; each message is a line of stderr.
void check_validation(const Device& device);

} // namespace prelight::app
