#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <prelight/scene.hpp>
#include <span>

namespace prelight {

inline constexpr double full_turn = 2 * std::numbers::pi; ///< radians

/// Sphere around the origin in `slices` × `stacks` quads of two triangles each. At the poles one of
/// a quad's two triangles has no area, so that the count is always 2 · slices · stacks. The seam's
/// vertices are there twice (u = 0 and u = 1); v runs from 0 at the top to 1. Metres.
/// Sines and cosines are taken in double and rounded to float: libraries that are right to 1 ulp of
/// double give the same float but for one case in about 10⁸.
Primitive make_sphere(float radius, uint32_t slices, uint32_t stacks);

/// Axis-aligned box, 12 triangles, 24 vertices, each face mapped to the whole 0 … 1 square. Metres.
Primitive make_box(glm::vec3 low, glm::vec3 high);

/// Horizontal rectangle around the origin at y = 0 facing up, `size` metres in x and z, divided
/// into `quads` × `quads`; texture coordinates 0 … 1, v along +z.
Primitive make_ground(glm::vec2 size, uint32_t quads);

/// Tube along a trefoil knot around the origin, in `along` × `around` quads. The knot winds about a torus of radius
/// `size` in the xy plane, and again `size` / 2 about that; `tube` is its own radius. Metres. Normals point out of the
/// tube; texture coordinates repeat without a seam: u 16 times along it, v once around.
Primitive make_knot(float size, float tube, uint32_t along, uint32_t around);

/// What turns about the y axis: `profile` holds radius and height, at least two, from the top down along the outside;
/// radius 0 closes it. Bends of less than 30° are smooth. Metres; no texture coordinates.
Primitive make_turned(std::span<const glm::dvec2> profile, uint32_t slices);

} // namespace prelight
