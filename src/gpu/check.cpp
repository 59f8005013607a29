#include "check.hpp"
#include <fmt/format.h>

namespace prelight::gpu {

std::string_view result_name(VkResult result) {
    switch (result) {
#define NAMED(name, words)                                                                                             \
    case name: return words " (" #name ")";
        NAMED(VK_ERROR_OUT_OF_HOST_MEMORY, "out of host memory")
        NAMED(VK_ERROR_OUT_OF_DEVICE_MEMORY, "out of device memory")
        NAMED(VK_ERROR_INITIALIZATION_FAILED, "initialization failed")
        NAMED(VK_ERROR_DEVICE_LOST, "the device was lost")
        NAMED(VK_ERROR_MEMORY_MAP_FAILED, "memory cannot be mapped")
        NAMED(VK_ERROR_LAYER_NOT_PRESENT, "layer not present")
        NAMED(VK_ERROR_EXTENSION_NOT_PRESENT, "extension not present")
        NAMED(VK_ERROR_FEATURE_NOT_PRESENT, "feature not present")
        NAMED(VK_ERROR_INCOMPATIBLE_DRIVER, "no Vulkan driver: on Debian, mesa-vulkan-drivers")
        NAMED(VK_ERROR_TOO_MANY_OBJECTS, "too many objects")
        NAMED(VK_ERROR_FORMAT_NOT_SUPPORTED, "format not supported")
        NAMED(VK_ERROR_FRAGMENTED_POOL, "fragmented pool")
        NAMED(VK_ERROR_UNKNOWN, "the driver does not say why")
        NAMED(VK_ERROR_OUT_OF_POOL_MEMORY, "out of pool memory")
        NAMED(VK_ERROR_INVALID_EXTERNAL_HANDLE, "invalid external handle")
        NAMED(VK_ERROR_FRAGMENTATION, "fragmented memory")
        NAMED(VK_ERROR_INVALID_OPAQUE_CAPTURE_ADDRESS, "invalid address")
        NAMED(VK_ERROR_SURFACE_LOST_KHR, "the surface was lost")
        NAMED(VK_ERROR_NATIVE_WINDOW_IN_USE_KHR, "the window is in use")
        NAMED(VK_ERROR_OUT_OF_DATE_KHR, "the swapchain is out of date")
        NAMED(VK_ERROR_VALIDATION_FAILED_EXT, "validation failed")
        NAMED(VK_ERROR_NOT_PERMITTED_KHR, "not permitted")
        NAMED(VK_NOT_READY, "not ready")
        NAMED(VK_TIMEOUT, "waited too long")
        NAMED(VK_INCOMPLETE, "incomplete")
        NAMED(VK_PIPELINE_COMPILE_REQUIRED, "a pipeline would have to be compiled")
#undef NAMED
    default: return "";
    }
}

void check(VkResult result, std::string_view what) {
    if (result == VK_SUCCESS)
        return;
    const std::string_view name = result_name(result);
    if (result == VK_ERROR_DEVICE_LOST)
        throw DeviceLost(fmt::format("{}: {}", what, name));
    throw Error(name.empty()
                    ? fmt::format("{}: VkResult {}, which Vulkan 1.3 has no name for", what, static_cast<int>(result))
                    : fmt::format("{}: {}", what, name));
}

} // namespace prelight::gpu
