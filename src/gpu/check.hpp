#pragma once
#include <prelight/error.hpp>
#include <string>
#include <string_view>
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// What a VkResult means, with its name, for messages: "the device was lost (VK_ERROR_DEVICE_LOST)".
/// Empty for one that Vulkan 1.3 does not have.
std::string_view result_name(VkResult result);

/// Throws Error "WHAT: reason" unless `result` is VK_SUCCESS; DeviceLost where that is the reason.
void check(VkResult result, std::string_view what);

} // namespace prelight::gpu
