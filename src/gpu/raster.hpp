#pragma once
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// What images, passes and pipelines that belong together have in common.
struct Raster {
    VkExtent2D extent{}; ///< pixels
    uint32_t samples = 1;
};

inline bool operator==(const Raster& a, const Raster& b) {
    return a.extent.width == b.extent.width && a.extent.height == b.extent.height && a.samples == b.samples;
}

} // namespace prelight::gpu
