#pragma once
#include <gpu/buffer.hpp>
#include <gpu/frames_in_flight.hpp>
#include <span>

namespace prelight::resident {

/// An occlusion query a draw: the first geometry pass counts the pixels that each draw leaves, and later ones
/// leave out the draws that left none. The counts go from the queries to a buffer on the device; the host never waits
/// for them.
class VisiblePixels {
public:
    /// Throws Error.
    VisiblePixels(const gpu::Context& context, uint32_t most_draws);

    /// Before the pass that counts, outside of rendering.
    void reset(VkCommandBuffer commands) const;
    void begin(VkCommandBuffer commands, uint32_t draw) const;
    void end(VkCommandBuffer commands, uint32_t draw) const;
    /// After it, outside of rendering: the first `draws` counts, for conditions and for the host.
    void copy(VkCommandBuffer commands, uint32_t slot, uint32_t draws) const;

    /// A count is not 0, or what stands between is left out.
    void begin_if_visible(VkCommandBuffer commands, uint32_t draw) const;
    void end_if_visible(VkCommandBuffer commands) const;

    const gpu::Buffer& conditions() const { return conditions_; }
    const gpu::PerFrame<gpu::Buffer>& host_counts() const { return host_counts_; }
    /// Draws without a pixel, of the slot's last frame, which must be done.
    uint64_t hidden(uint32_t slot, uint32_t draws) const;

private:
    const gpu::Context& context_;
    uint32_t most_;
    gpu::UniqueQueryPool queries_;
    gpu::Buffer conditions_;                 ///< uint32 a draw
    gpu::PerFrame<gpu::Buffer> host_counts_; ///< the same
};

} // namespace prelight::resident
