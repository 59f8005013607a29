#include "barrier.hpp"

namespace prelight::gpu {

void memory_barrier(VkCommandBuffer commands, VkPipelineStageFlags2 from, VkAccessFlags2 wrote,
                    VkPipelineStageFlags2 to, VkAccessFlags2 access) {
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = from;
    barrier.srcAccessMask = wrote;
    barrier.dstStageMask = to;
    barrier.dstAccessMask = access;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
}

} // namespace prelight::gpu
