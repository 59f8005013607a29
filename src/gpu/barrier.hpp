#pragma once
#include <vulkan/vulkan_core.h>

namespace prelight::gpu {

/// Between commands before and after, for whatever memory they touch that nobody declares to a frame graph.
void memory_barrier(VkCommandBuffer commands, VkPipelineStageFlags2 from, VkAccessFlags2 wrote,
                    VkPipelineStageFlags2 to, VkAccessFlags2 access);

} // namespace prelight::gpu
