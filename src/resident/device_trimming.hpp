#pragma once
#include "scene.hpp"
#include "visible_draws.hpp"
#include <gpu/frames_in_flight.hpp>
#include <shared/index_trimming.h>

namespace prelight::resident {

/// Buffers of index trimming on the device: what the host says of the visible objects, and the indices and
/// commands that passes/index_trimming.cpp makes of them. Each draw's indices stand where the host says, in the
/// order of the source; only their number comes from the device.
class DeviceTrimming {
public:
    /// What one trimming makes.
    struct Output {
        gpu::Buffer indices;                    ///< uint32
        gpu::Buffer commands;                   ///< VkDrawIndexedIndirectCommand, by visible draw
        gpu::PerFrame<gpu::Buffer> host_counts; ///< uint32 a visible draw: indices kept
        /// Of the slot's last frame, which must be done and have shown `draws`: those that the device trimmed and those
        /// that it drew whole, which it did not count.
        uint64_t triangles(uint32_t slot, std::span<const VisibleDraw> draws) const;
    };
    /// `indices`: room of each output. Throws Error when the geometry is larger than a storage buffer.
    DeviceTrimming(const gpu::Context& context, const Geometry& geometry, uint64_t indices, const DrawOptions& options);

    /// Before a frame: what the device is to trim, of the visible draws that are to be trimmed.
    void update(uint32_t slot, const VisibleDraws& visible, const Geometry& geometry);
    /// Workgroups of this frame.
    uint32_t groups() const { return groups_; }

    const gpu::PerFrame<gpu::Buffer>& draws() const { return draws_; }
    const gpu::PerFrame<gpu::Buffer>& group_list() const { return group_list_; }
    const gpu::Buffer& masks() const { return masks_; }
    const Output& first() const { return first_; } ///< for all passes: IndexTrimming::device
    const Output& later() const { return later_; } ///< for passes after the first: DrawOptions::trims_by_depth

private:
    gpu::PerFrame<gpu::Buffer> draws_, group_list_;
    gpu::Buffer masks_;
    Output first_, later_;
    uint32_t groups_ = 0;
};

} // namespace prelight::resident
