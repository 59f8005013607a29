#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// What the Round 2 sample shows: one textured model, here a trefoil knot of bricks with a normal map, under
/// `lights` directional lights of many colours from all around, six in the sample. The seed turns them.
Scene make_round2_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
