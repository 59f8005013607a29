#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <reference/transmission.hpp>

namespace prelight::reference {

double roughness_through(const Surface& surface, double roughness) {
    return roughness * std::min(2 * (surface.layers.ior - 1), 1.0);
}

LookBehind look_behind(const Surface& surface, const Lens& lens, glm::dvec2 pixel) {
    // Snell's law: the sine to the normal shrinks by the index, in the plane of normal and view.
    const double cosine = std::clamp(glm::dot(surface.normal, surface.view), 0.0, 1.0);
    const double sine = std::sqrt(1 - cosine * cosine) / surface.layers.ior;
    const glm::dvec3 along = cosine * surface.normal - surface.view; // away from the viewer, of length sin θ
    const glm::dvec3 refracted =
        glm::normalize(along / surface.layers.ior - std::sqrt(1 - sine * sine) * surface.normal);
    const glm::dvec3 leaves = surface.position + surface.layers.thickness * refracted;
    const double blur = roughness_through(surface, surface.layers.body_roughness);
    const double width = lens.longer_side() * (std::pow(1024, blur) - 1) / 1023;
    return {pixel + lens.place_of(leaves) - lens.place_of(surface.position), std::log2(1 + width)};
}

glm::dvec3 transmittance(const Surface& surface) {
    const double lengths = surface.layers.thickness / surface.layers.attenuation_distance;
    return glm::pow(glm::max(surface.layers.attenuation_colour, glm::dvec3(1e-6)), glm::dvec3(lengths));
}

} // namespace prelight::reference
