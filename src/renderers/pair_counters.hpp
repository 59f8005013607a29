#pragma once
#include <gpu/buffer.hpp>
#include <prelight/renderer.hpp>

namespace prelight {

/// Where shaders count light × pixel pairs: for each row of pixels how many were evaluated and how many of them
/// contributed. Rows apart, so that no counter of 32 bits runs over.
class PairCounters {
public:
    PairCounters(const gpu::Context& context, uint32_t height);
    const gpu::Buffer& buffer() const { return buffer_; }
    /// Sets all to 0 before a frame; the frame before may still count.
    void clear(VkCommandBuffer commands) const;
    /// Of a frame that is done.
    void tell(Stats& stats) const;

private:
    uint32_t height_;
    gpu::Buffer buffer_;
};

} // namespace prelight
