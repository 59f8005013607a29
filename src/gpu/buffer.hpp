#pragma once
#include "memory.hpp"
#include <functional>
#include <span>

namespace prelight::gpu {

enum class BufferPlace {
    device,   ///< device local; mapped where the host sees that memory too, as on software devices
    upload,   ///< host visible and coherent, written by the host each frame
    readback, ///< host visible and coherent, read by the host
};

/// A buffer with memory of its own.
class Buffer {
public:
    Buffer() = default;
    /// `size` ≥ 1 bytes. Throws Error.
    Buffer(const Context& context, std::string_view name, uint64_t size, VkBufferUsageFlags usage, BufferPlace place);

    VkBuffer handle() const { return buffer_; }
    uint64_t size() const { return size_; }
    template <class T>
    T* mapped() const {
        return reinterpret_cast<T*>(allocation_.mapped());
    }

private:
    Allocation allocation_;
    UniqueBuffer buffer_;
    uint64_t size_ = 0;
};

/// The buffer's bytes as RGBA32F texels, for shaders to fetch: as many as the device has in a texel buffer. The buffer
/// has the usage for it and outlives the view. Throws Error.
UniqueBufferView make_texel_view(const Context& context, std::string_view name, const Buffer& buffer);

/// A device buffer of `size` bytes (4 zero bytes when 0). `fill` writes all of them, in any order, and reads none:
/// where they are to stay if the host sees the device's memory, else into staging memory, which is copied. Waits.
Buffer make_device_buffer(const Context& context, std::string_view name, uint64_t size, VkBufferUsageFlags usage,
                          const std::function<void(std::byte*)>& fill);
/// A device buffer holding `bytes`.
Buffer make_device_buffer(const Context& context, std::string_view name, std::span<const std::byte> bytes,
                          VkBufferUsageFlags usage);

} // namespace prelight::gpu
