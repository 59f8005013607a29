#pragma once
#include <cstddef>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace prelight {

/// Notes what is passed to a few Vulkan functions while it lives, for mistakes that neither the
/// validation layer nor a software driver shows. One at a time. The functions themselves are
/// defined in vulkan_spy.cpp, before the loader's, and pass everything on to them.
class VulkanSpy {
public:
    VulkanSpy();
    ~VulkanSpy();
    VulkanSpy(const VulkanSpy&) = delete;
    VulkanSpy& operator=(const VulkanSpy&) = delete;
    static VulkanSpy*& active();

    std::vector<VkBufferMemoryBarrier2> buffer_barriers; ///< of vkCmdPipelineBarrier2, in order
    std::vector<std::vector<std::byte>> pipeline_caches; ///< initial data of vkCreatePipelineCache
};

} // namespace prelight
