#pragma once
#include "gpu_scene.hpp"
#include "shadow_plan.hpp"
#include "visible_draws.hpp"
#include <span>
#include <vector>

namespace prelight::resident {

/// The casters of shadow maps without triangles that cover no texel of their tile, which are most of them where tiles
/// are small: as trim_draws() makes them. Both faces cast. Returns all casters of the first map, then of the second …,
/// in their order.
std::vector<VisibleDraw> trim_casters(const GpuScene& scene, std::span<const ShadowMap> maps, std::span<uint32_t> room);

} // namespace prelight::resident
