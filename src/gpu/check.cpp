#include "check.hpp"
#include <fmt/format.h>

namespace prelight::gpu {

std::string_view result_name(VkResult result) {
    switch (result) {
    case VK_SUCCESS: return "success";
    case VK_ERROR_OUT_OF_HOST_MEMORY: return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY: return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED: return "initialization failed";
    case VK_ERROR_DEVICE_LOST: return "the device was lost";
    case VK_ERROR_LAYER_NOT_PRESENT: return "layer not present";
    case VK_ERROR_EXTENSION_NOT_PRESENT: return "extension not present";
    case VK_ERROR_FEATURE_NOT_PRESENT: return "feature not present";
    case VK_ERROR_INCOMPATIBLE_DRIVER: return "no Vulkan driver (on Debian: mesa-vulkan-drivers)";
    case VK_ERROR_TOO_MANY_OBJECTS: return "too many objects";
    case VK_ERROR_FORMAT_NOT_SUPPORTED: return "format not supported";
    default: return "";
    }
}

void check(VkResult result, std::string_view what) {
    if (result == VK_SUCCESS)
        return;
    const std::string_view name = result_name(result);
    throw Error(name.empty() ? fmt::format("{}: VkResult {}", what, static_cast<int>(result))
                             : fmt::format("{}: {}", what, name));
}

} // namespace prelight::gpu
