#pragma once
#include <cstdint>
#include <prelight/scene.hpp>

namespace prelight {

/// The baseline for speed: 250,284 triangles in 266 objects (a ground, 144 spheres, 121 columns)
/// under `lights` point lights of range 5 m and 12 cd with hues from `seed`.
Scene make_lights_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
