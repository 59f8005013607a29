#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <reference/environment.hpp>

namespace prelight::reference {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int rings = 32, spokes = 64; ///< of a lobe

} // namespace

glm::dvec3 EnvironmentLight::radiance(glm::dvec3 direction) const {
    const Image& image = environment_->image;
    const double longitude = std::atan2(direction.x, -direction.z);
    const double latitude = std::asin(std::clamp(direction.y, -1.0, 1.0));
    const double column = (longitude / (2 * pi) + 0.5) * image.width - 0.5;
    const double row = std::clamp((0.5 - latitude / pi) * image.height - 0.5, 0.0, double(image.height - 1));
    const double left = std::floor(column), top = std::floor(row);
    const auto texel = [&](double x, double y) {
        const auto width = int64_t(image.width);
        const int64_t wrapped = ((int64_t(x) % width) + width) % width;
        const int64_t clamped = std::min<int64_t>(int64_t(y), int64_t(image.height) - 1);
        return glm::dvec3(image.pixels[size_t(clamped) * image.width + size_t(wrapped)]);
    };
    const double s = column - left, t = row - top;
    return (1 - t) * ((1 - s) * texel(left, top) + s * texel(left + 1, top)) +
           t * ((1 - s) * texel(left, top + 1) + s * texel(left + 1, top + 1));
}

glm::dvec3 EnvironmentLight::lambert(glm::dvec3 normal) const {
    const glm::dvec3 helper = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, normal)), v = glm::cross(normal, u);
    glm::dvec3 sum(0);
    for (int ring = 0; ring < rings; ++ring)
        for (int spoke = 0; spoke < spokes; ++spoke) { // equal shares of ∫ cos θ dω: Malley's method
            const double sine2 = (ring + 0.5) / rings, phi = 2 * pi * (spoke + 0.5) / spokes;
            const double sine = std::sqrt(sine2), cosine = std::sqrt(1 - sine2);
            sum += radiance(normal * cosine + sine * (std::cos(phi) * u + std::sin(phi) * v));
        }
    return sum / double(rings * spokes);
}

glm::dvec3 EnvironmentLight::mirrored(glm::dvec3 direction, double roughness) const {
    const double a = roughness * roughness;
    if (a < 1e-6)
        return radiance(direction);
    const glm::dvec3 helper = std::abs(direction.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, direction)), v = glm::cross(direction, u);
    glm::dvec3 sum(0);
    double weight = 0;
    for (int ring = 0; ring < rings; ++ring) {
        // Equal shares of ∫ D N·H dω: tan² θ = a² e / (1 − e).
        const double e = (ring + 0.5) / rings, theta = std::atan(a * std::sqrt(e / (1 - e)));
        const double nl = std::cos(2 * theta);
        if (nl <= 0)
            continue;
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double phi = 2 * pi * (spoke + 0.5) / spokes;
            const glm::dvec3 light = direction * nl + std::sin(2 * theta) * (std::cos(phi) * u + std::sin(phi) * v);
            sum += nl * radiance(light);
            weight += nl;
        }
    }
    return sum / weight;
}

} // namespace prelight::reference
