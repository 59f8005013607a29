#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// Brick walls and a tiled floor with cracks, paint, bolts, a puddle and a burn on them, all decals; one moves.
/// `lights` go round over it.
Scene make_decals_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
