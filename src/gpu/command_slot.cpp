#include "command_slot.hpp"
#include "check.hpp"

namespace prelight::gpu {

CommandSlot make_command_slot(const Context& context, std::string_view name) {
    VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    info.queueFamilyIndex = context.queue_family();
    VkCommandPool pool = VK_NULL_HANDLE;
    check(vkCreateCommandPool(context.device(), &info, nullptr, &pool), "command pool");
    CommandSlot slot{{context.device(), pool}};
    context.set_name(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<uint64_t>(pool), name);
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(context.device(), &allocate, &slot.commands), "command buffer");
    context.set_name(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<uint64_t>(slot.commands), name);
    return slot;
}

void begin_commands(const Context& context, const CommandSlot& slot) {
    check(vkResetCommandPool(context.device(), slot.pool, 0), "command pool");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(slot.commands, &begin), "command buffer");
}

} // namespace prelight::gpu
