#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <reference/shared_surface.hpp>

namespace prelight::reference {
namespace {

constexpr double dark =
    0.02; // of a colour's channel: half a code of eight bits of what is darker is not relative to it
// Ten bits of an octahedral normal and eight of roughness or colour; depth of a float, and tangents of such normals.
constexpr double normal_step = 0.004, code = 1.0 / 255, depth_step = 0.02, cosine_step = 0.005;

/// `value` is at most `most`.
Shared at_most(double value, double most, double step) { return {value <= most, std::abs(value - most) > step}; }

double steepness(double nv) {
    const double cosine = std::clamp(nv, 1e-9, 1.0);
    return 1 + 2 * std::min(std::sqrt(1 - cosine * cosine) / cosine, 10.0);
}

/// What is equal is so as it is stored.
Shared alike(double a, double b, double most, double step) {
    return a == b || most == 0 ? Shared{a == b, true} : at_most(std::abs(a - b), most, step);
}

} // namespace

Shared share_surface(const Looks& first, const Looks& other, double pixel, const Likeness& likeness) {
    const Surface &a = first.surface, &b = other.surface;
    AllShared all;
    const double nv = std::abs(glm::dot(a.normal, a.view)), away = std::abs(other.depth - first.depth);
    const double least = pixel * steepness(nv + cosine_step) * (1 - depth_step);
    const double most = pixel * steepness(nv - cosine_step) * (1 + depth_step);
    all.add({away <= pixel * steepness(nv), away <= least || away > most});
    if (a.normal != b.normal)
        all.add(at_most(std::acos(std::clamp(glm::dot(a.normal, b.normal), -1.0, 1.0)), std::acos(likeness.cosine),
                        normal_step));
    all.add(alike(a.roughness, b.roughness, likeness.roughness * a.roughness, code));
    const auto colour = [&](double x, double y, double steps) {
        const double most = likeness.colour * std::max(std::abs(x), dark);
        if (std::isfinite(most))
            all.add(alike(x, y, most, steps * most));
    };
    for (int channel = 0; channel < 3; ++channel) {
        colour(a.base_colour[channel], b.base_colour[channel], 2); // eight bits
        colour(first.light[channel], other.light[channel], 0.25);  // half a float
    }
    colour(a.metallic, b.metallic, 2);
    return all.sum();
}

} // namespace prelight::reference
