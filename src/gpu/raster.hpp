#pragma once
#include <compare>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// What images that are drawn into together have in common.
struct Raster {
    VkExtent2D extent{}; ///< pixels
    uint32_t samples = 1;
};

/// What a pipeline knows of the images that it draws into.
struct Attachments {
    std::vector<VkFormat> colours; ///< in the order of the shader's outputs
    VkFormat depth = VK_FORMAT_UNDEFINED;
    VkFormat stencil = VK_FORMAT_UNDEFINED;
    uint32_t samples = 1;
    auto operator<=>(const Attachments&) const = default;
};

} // namespace prelight::gpu
