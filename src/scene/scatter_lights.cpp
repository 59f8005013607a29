#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <numbers>
#include <prelight/scene.hpp>
#include <scene/procedural/random.hpp>

namespace prelight {
namespace {

/// Area of a disc around the middle of a rectangle with half sides a, b that lies inside it.
double disc_in_rectangle(double r, double a, double b) {
    if (r * r >= a * a + b * b)
        return 4 * a * b;
    // Circular segments cut off beyond each side; they do not overlap while the corners are
    // outside.
    const auto segment = [r](double h) {
        return h >= r ? 0.0 : r * r * std::acos(h / r) - h * std::sqrt(r * r - h * h);
    };
    return std::numbers::pi * r * r - 2 * segment(a) - 2 * segment(b);
}

/// Share of a box (half sides h) within r of its middle.
double share_within(double r, glm::dvec3 h) {
    constexpr int slices = 64;
    const double top = std::min(r, h.z);
    double sum = 0;
    for (int i = 0; i < slices; ++i) {
        const double z = top * (i + 0.5) / slices;
        sum += disc_in_rectangle(std::sqrt(std::max(0.0, r * r - z * z)), h.x, h.y);
    }
    return sum / slices * top / (4 * h.x * h.y * h.z);
}

/// Range with which `count` lights, uniform in the box, put 8 on its middle; the diagonal when
/// there are no more than 8. A flat box counts as one a thousandth as thick as long.
double range_for(uint32_t count, glm::dvec3 size) {
    const double longest = std::max({size.x, size.y, size.z});
    if (longest <= 0)
        return 1;
    const glm::dvec3 half = 0.5 * glm::max(size, glm::dvec3(longest * 1e-3));
    const double diagonal = glm::length(size);
    if (count <= 8)
        return diagonal;
    double low = 0, high = diagonal;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (share_within(middle, half) * count < 8 ? low : high) = middle;
    }
    return high;
}

} // namespace

void scatter_lights(World& world, uint32_t count, uint64_t seed) {
    const glm::dvec3 size = world.bounds_max - world.bounds_min;
    const auto range = float(range_for(count, size));
    Random random(seed);
    world.lights.reserve(world.lights.size() + count);
    for (uint32_t i = 0; i < count; ++i) {
        PlacedLight placed;
        placed.light.name = fmt::format("scattered {}", i);
        placed.light.range = range;
        placed.light.intensity = range * range / 2;
        const double x = random.unit(), y = random.unit(), z = random.unit();
        placed.position = world.bounds_min + size * glm::dvec3(x, y, z);
        placed.light.colour = hue_colour(random.unit(), 0.8);
        world.lights.push_back(std::move(placed));
    }
}

} // namespace prelight
