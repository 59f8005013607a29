#pragma once
#include <cstdint>
#include <prelight/export.hpp>
#include <prelight/scene.hpp>
#include <span>

namespace prelight {

// What a person changes while looking at many lights on a few objects, as the XNA multipass sample
// lets them. Lights go back to a renderer by Renderer::set_lights, materials by set_world.

/// Turns positions and directions by `angle` radians, counter-clockwise seen from above, around the
/// vertical (+Y) line through `centre` (world, metres).
PRELIGHT_API void rotate_lights(std::span<PlacedLight> lights, glm::dvec3 centre, double angle);

/// Gives each light a new kind (point or spot), colour, cone, and a range of 0.5 … 2 times the one it
/// had (that of one without range: what puts about 8 of so many lights on a point of a cube of 10 m);
/// positions stay. Intensity becomes range²/2 cd. The same seed gives the same lights.
PRELIGHT_API void randomize_lights(std::span<PlacedLight> lights, uint64_t seed);

/// Every primitive takes the next of the scene's materials, and the first after the last; one that has
/// a normal map gets tangents.
/// `scene` has materials.
PRELIGHT_API void cycle_materials(Scene& scene);

} // namespace prelight
