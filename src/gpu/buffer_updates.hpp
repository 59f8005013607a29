#pragma once
#include "buffer.hpp"
#include <map>
#include <utility>
#include <vector>

namespace prelight::gpu {

/// What the host changes in device buffers between two frames. The next frame copies it before its passes, so that
/// frames in flight still read what was there.
class BufferUpdates {
public:
    explicit BufferUpdates(const Context& context) : context_(context) {}
    /// Bytes of `target`, made with make_device_buffer(), from `offset` on; both sizes are multiples of 4. If the same
    /// range is written again, the later bytes count; ranges that overlap in any other way are not allowed.
    void write(const Buffer& target, uint64_t offset, std::span<const std::byte> bytes);
    /// Bytes that wait for record().
    uint64_t waiting() const { return bytes_.size(); }
    /// Into the frame's commands, through `staging`, which no frame in flight may use; it grows as needed.
    void record(VkCommandBuffer commands, Buffer& staging);

private:
    struct Region {
        VkBuffer target = VK_NULL_HANDLE;
        VkBufferCopy copy{}; ///< from an offset in `bytes_`
    };
    const Context& context_;
    std::vector<std::byte> bytes_;
    std::vector<Region> regions_;
    std::map<std::pair<VkBuffer, uint64_t>, size_t> known_; ///< target and offset → its region
};

} // namespace prelight::gpu
