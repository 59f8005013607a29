#pragma once
#include <cstdint>
#include <prelight/scene.hpp>

namespace prelight {

/// What shadows are hard for: thin walls and poles that stand on the ground, spheres that hang above it, a fence
/// with holes, steps, and columns up to 60 m away; under a low sun and, from the second of `lights` on, a point
/// light, a narrow spot and a wide spot (75°) in turn, places from `seed` once the first three stand.
Scene make_shadows_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
