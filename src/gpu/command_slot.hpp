#pragma once
#include "context.hpp"
#include "handle.hpp"

namespace prelight::gpu {

/// A command buffer with a pool of its own, recorded again and again.
struct CommandSlot {
    UniqueCommandPool pool;
    VkCommandBuffer commands = VK_NULL_HANDLE;
};

/// Throws Error.
CommandSlot make_command_slot(const Context& context, std::string_view name);
/// Forgets what was recorded, which must be done, and begins anew: for one submission. Throws Error.
void begin_commands(const Context& context, const CommandSlot& slot);

} // namespace prelight::gpu
