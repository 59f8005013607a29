#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <scene/place_camera.hpp>

namespace prelight {

glm::dvec3 unit_or(glm::dvec3 v, glm::dvec3 fallback) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest > 0 ? glm::normalize(v / largest) : fallback;
}

PlacedCamera place_camera(const Camera& camera, const glm::dmat4& world) {
    const glm::dvec3 back = unit_or(glm::dvec3(world[2]), {0, 0, 1});
    glm::dvec3 up = unit_or(glm::dvec3(world[1]), {0, 1, 0});
    up -= back * glm::dot(up, back);
    if (glm::length(up) < 1e-9) // flattened: any up will do
        up = glm::cross(back, std::abs(back.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    up = glm::normalize(up);
    return {camera, glm::dvec3(world[3]), glm::dmat3(glm::cross(up, back), up, back)};
}

} // namespace prelight
