#pragma once
#include <cmath>
#include <glm/geometric.hpp>

namespace prelight::reference {

/// Whether two shading normals are at most 30° apart.
inline bool same_direction(glm::dvec3 a, glm::dvec3 b) { return glm::dot(a, b) >= 0.86602540378443865; }

/// Whether a point lies on the plane of another one, but for 1 % of that one's depth.
inline bool same_plane(glm::dvec3 position, glm::dvec3 geometric_normal, double depth, glm::dvec3 other) {
    return std::abs(glm::dot(other - position, geometric_normal)) <= 0.01 * depth;
}

} // namespace prelight::reference
