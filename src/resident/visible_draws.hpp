#pragma once
#include "scene.hpp"
#include <array>
#include <gpu/raster.hpp>
#include <numeric>
#include <prelight/camera.hpp>
#include <shared/frame.h>
#include <vulkan/vulkan_core.h>

namespace prelight::resident {

/// Which triangles of a visible object are sent to the device.
enum class IndexTrimming { off, host, device };

/// How the visible objects of a frame become draw calls.
struct DrawOptions {
    bool frustum_culling = true;
    bool instanced = false; ///< neighbours with the same mesh and material are one draw
    bool indirect = false;  ///< draws come from a buffer, many in one call where the device can
    IndexTrimming trimming = IndexTrimming::off;
    bool counts_pixels = false;  ///< draws of which the first pass left no pixel are not drawn again
    bool trims_by_depth = false; ///< nor are triangles that lie behind what the first pass left

    bool trims_on_device() const { return trimming == IndexTrimming::device || trims_by_depth; }
};

/// A draw that the camera may see.
struct VisibleDraw {
    uint32_t draw = 0;     ///< index into Geometry::draws
    uint32_t instance = 0; ///< its place in the buffer of objects
    uint32_t first_index = 0, index_count = 0;
    bool trimmed = false;        ///< the indices are of the host's buffer of trimmed ones
    bool device_trimmed = false; ///< the device makes others of them
};

/// One draw call, of one object or of several that differ in nothing but their ObjectData.
struct DrawBatch {
    uint32_t draw = 0;                            ///< the first of them: pipeline, material and faces are those of all
    bool trimmed = false, device_trimmed = false; ///< as VisibleDraw's
    VkDrawIndexedIndirectCommand command{};
};

/// What a camera may see of a world, in the order in which every pass draws it: opaque draws first, what one call
/// may show together, and front to back: occluders come first; then transmissive ones; then blended ones, back to
/// front. The order is the same for all DrawOptions, and so is the picture where surfaces coincide.
struct VisibleDraws {
    std::vector<VisibleDraw> draws;
    std::vector<DrawBatch> batches;            ///< of opaque draws
    std::array<size_t, draw_classes> counts{}; ///< of `draws`, by class
    std::vector<uint32_t> place;               ///< by index into Geometry::draws: index into `draws`, or no_image
    uint64_t triangles = 0;                    ///< of all draws
    uint64_t trimmed = 0;                      ///< indices that the host trimmed
    double helpers_ms = 0;                     ///< CPU time of threads beside the calling one that trimmed them
    std::vector<shared::ObjectData> records;   ///< find_visible()'s own, kept for their memory

    std::span<const VisibleDraw> of(DrawClass which) const {
        const auto place = counts.begin() + static_cast<ptrdiff_t>(which);
        return std::span(draws).subspan(std::accumulate(counts.begin(), place, size_t(0)), *place);
    }
    /// By the depth of the middle of their bounds, the farthest first; at the same depth in the world's order.
    std::span<const VisibleDraw> blended() const { return of(DrawClass::blended); }
    std::span<const VisibleDraw> transmissive() const { return of(DrawClass::transmissive); }
    const VisibleDraw* find(uint32_t draw) const { return place[draw] == no_image ? nullptr : &draws[place[draw]]; }
};

/// Where find_visible() writes what the device reads: each has room for every draw of the geometry.
struct DrawBuffers {
    shared::ObjectData* objects = nullptr;            ///< in the order of VisibleDraws::draws
    VkDrawIndexedIndirectCommand* commands = nullptr; ///< in the order of the batches
    std::span<uint32_t> indices;                      ///< trimmed ones; what does not fit is drawn whole
    uint64_t device_indices = 0;                      ///< room of the device for those it trims; the same
};

/// `constants`: of this frame's camera, which stands at `eye`, drawn into `raster`.
void find_visible(VisibleDraws& out, const Geometry& geometry, const World& world,
                  const shared::FrameConstants& constants, const gpu::Raster& raster, glm::dvec3 eye,
                  uint32_t subpixel_bits, const DrawOptions& options, const DrawBuffers& buffers);

} // namespace prelight::resident
