#include "vulkan_spy.hpp"
#include <dlfcn.h>

namespace prelight {
namespace {

template <class Function>
Function loaders(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

} // namespace

VulkanSpy::VulkanSpy() { active() = this; }
VulkanSpy::~VulkanSpy() { active() = nullptr; }

VulkanSpy*& VulkanSpy::active() {
    static VulkanSpy* spy = nullptr;
    return spy;
}

} // namespace prelight

extern "C" {

VKAPI_ATTR void VKAPI_CALL vkCmdPipelineBarrier2(VkCommandBuffer commands, const VkDependencyInfo* info) {
    if (prelight::VulkanSpy* spy = prelight::VulkanSpy::active())
        spy->buffer_barriers.insert(spy->buffer_barriers.end(), info->pBufferMemoryBarriers,
                                    info->pBufferMemoryBarriers + info->bufferMemoryBarrierCount);
    static const auto next = prelight::loaders<PFN_vkCmdPipelineBarrier2>("vkCmdPipelineBarrier2");
    next(commands, info);
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreatePipelineCache(VkDevice device, const VkPipelineCacheCreateInfo* info,
                                                     const VkAllocationCallbacks* allocator, VkPipelineCache* cache) {
    if (prelight::VulkanSpy* spy = prelight::VulkanSpy::active()) {
        const auto* data = static_cast<const std::byte*>(info->pInitialData);
        spy->pipeline_caches.emplace_back(data, data + info->initialDataSize);
    }
    static const auto next = prelight::loaders<PFN_vkCreatePipelineCache>("vkCreatePipelineCache");
    return next(device, info, allocator, cache);
}

} // extern "C"
