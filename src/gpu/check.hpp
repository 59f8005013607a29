#pragma once
#include <prelight/error.hpp>
#include <string>
#include <string_view>
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// A VkResult's name, for messages ("VK_ERROR_DEVICE_LOST").
std::string_view result_name(VkResult result);

/// Throws Error "WHAT: reason" unless `result` is VK_SUCCESS.
void check(VkResult result, std::string_view what);

} // namespace prelight::gpu
