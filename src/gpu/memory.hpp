#pragma once
#include "context.hpp"
#include <vector>

namespace prelight::gpu {

/// Owns one VkDeviceMemory; mapped for its whole life when host visible.
class Allocation {
public:
    Allocation() = default;
    Allocation(const Context& context, uint64_t size, uint32_t memory_type, bool map);
    Allocation(Allocation&& other) noexcept { swap(other); }
    Allocation& operator=(Allocation&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Allocation();

    VkDeviceMemory memory() const { return memory_; }
    uint64_t size() const { return size_; }
    std::byte* mapped() const { return static_cast<std::byte*>(mapped_); }

private:
    void swap(Allocation& other);
    const Context* context_ = nullptr;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    uint64_t size_ = 0;
    void* mapped_ = nullptr;
};

/// Device-local memory handed out in order from blocks, given back all at once: for a scene's
/// textures, which live and die together.
class MemoryPool {
public:
    explicit MemoryPool(const Context& context) : context_(context) {}
    struct Slice {
        VkDeviceMemory memory = VK_NULL_HANDLE;
        uint64_t offset = 0;
    };
    Slice take(const VkMemoryRequirements& requirements);

private:
    struct Block {
        Allocation allocation;
        uint32_t type = 0;
        uint64_t used = 0;
    };
    const Context& context_;
    std::vector<Block> blocks_;
};

} // namespace prelight::gpu
