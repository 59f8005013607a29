#pragma once
#include <glm/mat4x4.hpp>
#include <prelight/camera.hpp>

namespace prelight {

/// The vector made a unit vector, however small or large; `fallback` where it is zero.
glm::dvec3 unit_or(glm::dvec3 v, glm::dvec3 fallback);

/// The camera at a node whose place in the world is `world`; scale and shear are left aside.
PlacedCamera place_camera(const Camera& camera, const glm::dmat4& world);

} // namespace prelight
