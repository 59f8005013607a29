#pragma once
#include <cstdint>
#include <set>
#include <vulkan/vulkan_core.h>

namespace prelight {

/// Counts calls of a few Vulkan functions while it lives, whoever makes them. One at a time. The
/// functions are defined in vulkan_calls.cpp, before the loader's, and pass everything on to them.
class VulkanCalls {
public:
    VulkanCalls();
    ~VulkanCalls();
    VulkanCalls(const VulkanCalls&) = delete;
    VulkanCalls& operator=(const VulkanCalls&) = delete;
    static VulkanCalls*& active();

    uint64_t submits = 0;
    /// Submissions that came while the one before was not done, told by the timeline semaphore that each
    /// signals; 0 without a device.
    uint64_t overlapping = 0;
    VkDevice device = VK_NULL_HANDLE;
    uint64_t waits = 0;                   ///< for semaphores
    std::set<VkDescriptorSet> frame_sets; ///< that were bound as SET_FRAME
    uint64_t draws = 0, instances = 0;    ///< of draws that the host counts: not indirect ones
    uint64_t allocations = 0, pipelines = 0, buffers = 0, images = 0, descriptor_pools = 0;
};

} // namespace prelight
