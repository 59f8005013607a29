#pragma once
#include <reference/ray_scene.hpp>

namespace prelight::reference {

/// Ambient occlusion by rays: the share of directions over `normal`, weighted by cosine, that nothing blocks within
/// `radius` metres. What blocks at distance d counts 1 − (d / radius)²: nothing appears at the radius. A fixed set of
/// rays, the same at every point.
double ray_visibility(const RayScene& scene, const Hit& hit, glm::dvec3 normal, double radius);

} // namespace prelight::reference
