#pragma once
#include <cstdint>
#include <prelight/scene.hpp>

namespace prelight {

/// A wall of 8 × 5 spheres facing the camera: shininess falls from left to right (roughness 0.1 …
/// 1), metalness rises from the bottom row (0) to the top one (1). `lights` point lights of 60 cd
/// in total hang in front of it at places from `seed`.
Scene make_spheres_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
