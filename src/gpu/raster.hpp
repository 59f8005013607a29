#pragma once
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// What images, passes and pipelines that belong together have in common.
struct Raster {
    VkExtent2D extent{}; ///< pixels
    uint32_t samples = 1;
};

} // namespace prelight::gpu
