#include "vulkan_calls.hpp"
#include <dlfcn.h>
#include <shared/bindings.h>

namespace prelight {
namespace {

/// The loader's own function, after counting one call.
template <class Function>
Function pass_on(Function, const char* name, uint64_t VulkanCalls::*count, uint64_t by = 1) {
    if (VulkanCalls::active())
        VulkanCalls::active()->*count += by;
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

} // namespace

VulkanCalls*& VulkanCalls::active() {
    static VulkanCalls* calls = nullptr;
    return calls;
}

VulkanCalls::VulkanCalls() { active() = this; }
VulkanCalls::~VulkanCalls() { active() = nullptr; }

} // namespace prelight

using prelight::VulkanCalls, prelight::pass_on;

extern "C" {

VKAPI_ATTR VkResult VKAPI_CALL vkQueueSubmit2(VkQueue queue, uint32_t count, const VkSubmitInfo2* infos,
                                              VkFence fence) {
    if (VulkanCalls* calls = VulkanCalls::active(); calls && calls->device)
        for (uint32_t i = 0; i < count; ++i) {
            uint64_t done = 0;
            const VkSemaphoreSubmitInfo& signal = infos[i].pSignalSemaphoreInfos[0];
            vkGetSemaphoreCounterValue(calls->device, signal.semaphore, &done);
            calls->overlapping += done + 1 < signal.value;
        }
    return pass_on(&vkQueueSubmit2, "vkQueueSubmit2", &VulkanCalls::submits)(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL vkWaitSemaphores(VkDevice device, const VkSemaphoreWaitInfo* info, uint64_t timeout) {
    return pass_on(&vkWaitSemaphores, "vkWaitSemaphores", &VulkanCalls::waits)(device, info, timeout);
}

VKAPI_ATTR void VKAPI_CALL vkCmdBindDescriptorSets(VkCommandBuffer commands, VkPipelineBindPoint point,
                                                   VkPipelineLayout layout, uint32_t first, uint32_t count,
                                                   const VkDescriptorSet* sets, uint32_t offset_count,
                                                   const uint32_t* offsets) {
    if (VulkanCalls* calls = VulkanCalls::active(); calls && first == SET_FRAME)
        calls->frame_sets.insert(sets[0]);
    reinterpret_cast<PFN_vkCmdBindDescriptorSets>(dlsym(RTLD_NEXT, "vkCmdBindDescriptorSets"))(
        commands, point, layout, first, count, sets, offset_count, offsets);
}

VKAPI_ATTR void VKAPI_CALL vkCmdDraw(VkCommandBuffer commands, uint32_t vertices, uint32_t instances,
                                     uint32_t first_vertex, uint32_t first_instance) {
    if (VulkanCalls* calls = VulkanCalls::active())
        calls->instances += instances;
    pass_on(&vkCmdDraw, "vkCmdDraw", &VulkanCalls::draws)(commands, vertices, instances, first_vertex, first_instance);
}

VKAPI_ATTR void VKAPI_CALL vkCmdDrawIndexed(VkCommandBuffer commands, uint32_t indices, uint32_t instances,
                                            uint32_t first_index, int32_t vertex_offset, uint32_t first_instance) {
    if (VulkanCalls* calls = VulkanCalls::active())
        calls->instances += instances;
    pass_on(&vkCmdDrawIndexed, "vkCmdDrawIndexed", &VulkanCalls::draws)(commands, indices, instances, first_index,
                                                                        vertex_offset, first_instance);
}

VKAPI_ATTR VkResult VKAPI_CALL vkAllocateMemory(VkDevice device, const VkMemoryAllocateInfo* info,
                                                const VkAllocationCallbacks* allocator, VkDeviceMemory* memory) {
    return pass_on(&vkAllocateMemory, "vkAllocateMemory", &VulkanCalls::allocations)(device, info, allocator, memory);
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreateGraphicsPipelines(VkDevice device, VkPipelineCache cache, uint32_t count,
                                                         const VkGraphicsPipelineCreateInfo* infos,
                                                         const VkAllocationCallbacks* allocator,
                                                         VkPipeline* pipelines) {
    return pass_on(&vkCreateGraphicsPipelines, "vkCreateGraphicsPipelines", &VulkanCalls::pipelines,
                   count)(device, cache, count, infos, allocator, pipelines);
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreateComputePipelines(VkDevice device, VkPipelineCache cache, uint32_t count,
                                                        const VkComputePipelineCreateInfo* infos,
                                                        const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    return pass_on(&vkCreateComputePipelines, "vkCreateComputePipelines", &VulkanCalls::pipelines,
                   count)(device, cache, count, infos, allocator, pipelines);
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreateBuffer(VkDevice device, const VkBufferCreateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkBuffer* buffer) {
    return pass_on(&vkCreateBuffer, "vkCreateBuffer", &VulkanCalls::buffers)(device, info, allocator, buffer);
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreateImage(VkDevice device, const VkImageCreateInfo* info,
                                             const VkAllocationCallbacks* allocator, VkImage* image) {
    return pass_on(&vkCreateImage, "vkCreateImage", &VulkanCalls::images)(device, info, allocator, image);
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreateDescriptorPool(VkDevice device, const VkDescriptorPoolCreateInfo* info,
                                                      const VkAllocationCallbacks* allocator, VkDescriptorPool* pool) {
    return pass_on(&vkCreateDescriptorPool, "vkCreateDescriptorPool", &VulkanCalls::descriptor_pools)(device, info,
                                                                                                      allocator, pool);
}

} // extern "C"
