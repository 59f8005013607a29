#pragma once
#include "gpu_scene.hpp"
#include "shadow_plan.hpp"
#include <span>
#include <vector>

namespace prelight::resident {

/// What is drawn of one caster into one tile.
struct TrimmedCaster {
    uint32_t first_index = 0, index_count = 0;
    bool trimmed = false; ///< the indices are of the room that trim_casters() wrote to
};

/// The casters of shadow maps without triangles that cover no texel of their tile, which are most of them where tiles
/// are small. Both faces cast. On all processors; the result does not depend on how many there are. What does not fit
/// into `room` is drawn whole. Returns all casters of the first map, then of the second …, in their order.
std::vector<TrimmedCaster> trim_casters(const GpuScene& scene, std::span<const ShadowMap> maps,
                                        std::span<uint32_t> room);

} // namespace prelight::resident
