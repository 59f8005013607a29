#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
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

PlacedCamera framed_camera(glm::dvec3 low, glm::dvec3 high) {
    Camera camera;
    camera.name = "framed";
    camera.yfov = 0.87;
    const glm::dvec3 centre = 0.5 * low + 0.5 * high;
    glm::dvec3 half = 0.5 * high - 0.5 * low;
    if (half == glm::dvec3(0))
        half = glm::dvec3(0.5);
    PlacedCamera placed = look_at(camera, centre + glm::dvec3(1, 0.6, 1.4), centre);
    placed.axes = look_at(camera, {1, 0.6, 1.4}, {0, 0, 0}).axes; // exact however far the centre is
    const double tangent = std::tan(camera.yfov / 2);
    double distance = 0, nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    std::array<glm::dvec3, 8> corners;
    for (uint32_t i = 0; i < 8; ++i) {
        const glm::dvec3 sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        corners[i] = glm::transpose(placed.axes) * (half * sign);
        const double extent = std::max(std::abs(corners[i].x), std::abs(corners[i].y));
        distance = std::max(distance, corners[i].z + 1.02 * extent / tangent);
    }
    for (const glm::dvec3& corner : corners) {
        nearest = std::min(nearest, distance - corner.z);
        farthest = std::max(farthest, distance - corner.z);
    }
    placed.camera.zfar = 1.5 * farthest;
    placed.camera.znear = std::max(0.5 * nearest, 1e-4 * farthest);
    placed.position = centre + placed.axes[2] * distance;
    return placed;
}

} // namespace prelight
