#pragma once
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// A picture of four bytes a pixel that lies on the device, and how it was touched last; it is to be left so.
struct ShownImage {
    VkImage image = VK_NULL_HANDLE;
    VkExtent2D extent{};
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

} // namespace prelight::gpu
