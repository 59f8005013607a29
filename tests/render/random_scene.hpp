#pragma once
#include "against_reference.hpp"
#include <reference/worlds.hpp>

namespace prelight {

/// A scene drawn by lot: a floor, 4 … 10 spheres and boxes turned and stretched (some mirrored) of
/// random materials (of roughness that 8 bits hold exactly: what their steps cost is another question,
/// answered in docs/figures.md), 1 … 24 lights of every kind, range and cone, a camera of either projection that
/// looks at the middle, sometimes from within a light's range.
struct RandomScene : TestWorld {
    explicit RandomScene(uint64_t seed);
    PlacedCamera camera;
    Shot shot() const { return {.world = &world, .camera = camera, .width = 300, .height = 200}; }
};

/// A cube from −1 to 1 with flat faces.
Primitive cube();

} // namespace prelight
