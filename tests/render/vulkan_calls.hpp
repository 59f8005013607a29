#pragma once
#include <cstdint>

namespace prelight {

/// Counts calls of a few Vulkan functions while it lives, whoever makes them. One at a time. The
/// functions are defined in vulkan_calls.cpp, before the loader's, and pass everything on to them.
class VulkanCalls {
public:
    VulkanCalls();
    ~VulkanCalls();
    VulkanCalls(const VulkanCalls&) = delete;
    VulkanCalls& operator=(const VulkanCalls&) = delete;

    uint64_t submits = 0;
    uint64_t allocations = 0, pipelines = 0, buffers = 0, images = 0, descriptor_pools = 0;
};

} // namespace prelight
