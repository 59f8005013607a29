#pragma once
#include <scene/procedural/shapes.hpp>

namespace prelight {

/// Sphere of radius 1 with two morph targets: a star with six blunt points along the axes, and an egg
/// that stands. Normals come with them.
Primitive make_morphing_sphere(uint32_t slices, uint32_t stacks);

/// Upright column from y = 0 to `height` with a top, whose vertices follow `joints` joints at equal
/// distances, the first at the bottom; between two of them the weights change over smoothly.
/// Texture coordinates: u once around, v along −y in units of `height`.
Primitive make_jointed_column(float radius, float height, uint32_t joints);

} // namespace prelight
