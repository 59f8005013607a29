#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// Everything that glTF animates, on a stage of 16 × 16 m, in loops of 4 s: a carousel of turning boxes
/// ("turn"), a bent column with five joints ("bend"), a sphere that morphs ("morph"), two rings of
/// lights that circle against each other ("lights"), a camera in flight ("flight") and a hand that
/// jumps ("tick"). Cameras: "front", which stands still, and "flight".
Scene make_motion_scene(uint32_t lights, uint64_t seed);

} // namespace prelight
