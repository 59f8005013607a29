#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <reference/visibility.hpp>

namespace prelight::reference {
namespace {

constexpr int rays = 128;

} // namespace

double ray_visibility(const RayScene& scene, const Hit& hit, glm::dvec3 normal, double radius) {
    const glm::dvec3 helper = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, normal)), v = glm::cross(normal, u);
    const glm::dvec3 start = hit.position + hit.geometric_normal * hit.offset;
    double blocked = 0;
    for (int i = 0; i < rays; ++i) {
        // Equal shares of ∫ cos θ dω on a Fibonacci lattice: Malley's method.
        const double sine2 = (i + 0.5) / rays, phi = 2 * std::numbers::pi * i / std::numbers::phi;
        const double sine = std::sqrt(sine2), cosine = std::sqrt(1 - sine2);
        const glm::dvec3 direction = normal * cosine + sine * (std::cos(phi) * u + std::sin(phi) * v);
        const double far = scene.blocked_at({start, direction, 0, radius});
        if (far < radius)
            blocked += 1 - far * far / (radius * radius);
    }
    return 1 - blocked / rays;
}

} // namespace prelight::reference
