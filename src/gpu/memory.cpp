#include "memory.hpp"
#include "check.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace prelight::gpu {

Allocation::Allocation(const Context& context, uint64_t size, uint32_t memory_type, bool map)
    : context_(&context), size_(size) {
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = size;
    info.memoryTypeIndex = memory_type;
    check(vkAllocateMemory(context.device(), &info, nullptr, &memory_),
          fmt::format("{}: {} bytes of memory", context.name(), size));
    context.memory_taken(size);
    if (map)
        check(vkMapMemory(context.device(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped_), "map memory");
}

Allocation::~Allocation() {
    if (!memory_)
        return;
    vkFreeMemory(context_->device(), memory_, nullptr);
    context_->memory_freed(size_);
}

void Allocation::swap(Allocation& other) {
    std::swap(context_, other.context_);
    std::swap(memory_, other.memory_);
    std::swap(size_, other.size_);
    std::swap(mapped_, other.mapped_);
}

MemoryPool::Slice MemoryPool::take(const VkMemoryRequirements& requirements) {
    constexpr uint64_t block_size = 16u << 20;
    const uint32_t type = context_.memory_type(requirements.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    // Images and buffers are never mixed in one pool, so that bufferImageGranularity does not matter.
    const auto aligned = [&](uint64_t offset) {
        return (offset + requirements.alignment - 1) / requirements.alignment * requirements.alignment;
    };
    for (Block& block : blocks_)
        if (block.type == type && aligned(block.used) + requirements.size <= block.allocation.size()) {
            const uint64_t offset = aligned(block.used);
            block.used = offset + requirements.size;
            return {block.allocation.memory(), offset};
        }
    blocks_.push_back(
        {Allocation(context_, std::max(block_size, requirements.size), type, false), type, requirements.size});
    return {blocks_.back().allocation.memory(), 0};
}

} // namespace prelight::gpu
