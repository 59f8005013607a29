#include "light_reach.hpp"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <prelight/light_distribution.hpp>
#include <shared/bindings.h>

namespace prelight::resident {
namespace {

/// Distance from a light to the nearest point of a box, metres.
double distance_to(glm::dvec3 light, const Draw& draw) {
    return glm::distance(light, glm::clamp(light, draw.low, draw.high));
}

bool misses_cone(const LightVolume& light, const Draw& draw) {
    const glm::dvec3 to_centre = 0.5 * (draw.low + draw.high) - light.position;
    const double radius = 0.5 * glm::distance(draw.low, draw.high);
    const double along = glm::dot(to_centre, light.direction);
    const double across = std::sqrt(std::max(0.0, glm::dot(to_centre, to_centre) - along * along));
    const double angle = light.outer_cone;
    // A sphere's distance from the cone's side is at least that from the line on which the side lies.
    return across * std::cos(angle) - along * std::sin(angle) > radius * 1.0001;
}

} // namespace

LightVolume::LightVolume(const PlacedLight& light)
    : kind(light.light.kind), position(light.position), direction(light.direction), range(light.light.range),
      outer_cone(light.light.outer_cone) {}

bool reaches(const LightVolume& light, const Draw& draw) {
    if (light.kind == LightKind::directional)
        return true;
    // The shader works in single precision: a little more than the range.
    if (distance_to(light.position, draw) > light.range * 1.0001)
        return false;
    return light.kind != LightKind::spot || !misses_cone(light, draw);
}

double strength(const PlacedLight& placed, const Draw& draw) {
    const Light& light = placed.light;
    const double luminance = glm::dot(glm::dvec3(light.colour), {0.2126, 0.7152, 0.0722}) * largest_intensity(light);
    if (light.kind == LightKind::directional)
        return luminance;
    const double d = distance_to(placed.position, draw), x = d / double(light.range);
    switch (light.falloff) {
    case Falloff::linear: return luminance * std::max(0.0, 1 - x);
    case Falloff::quadratic: return luminance * std::max(0.0, 1 - x * x);
    case Falloff::gltf: break;
    }
    return luminance * std::max(0.0, 1 - x * x * x * x) / std::max(d * d, 1e-4);
}

LightReach find_reach(std::span<const Draw> draws, std::span<const PlacedLight> lights,
                      std::span<const uint32_t> visible, ObjectLights order, ObjectLights blended) {
    LightReach reach;
    reach.first.assign(draws.size() + 1, 0);
    if (order == ObjectLights::none && blended == ObjectLights::none)
        return reach;
    std::vector<uint32_t> sorted(visible.begin(), visible.end());
    std::sort(sorted.begin(), sorted.end());
    std::vector<LightVolume> volumes;
    for (const uint32_t light : sorted)
        volumes.emplace_back(lights[light]);
    std::vector<std::pair<double, uint32_t>> strongest;
    for (size_t d = 0; d < draws.size(); ++d) {
        strongest.clear();
        const ObjectLights own =
            order == ObjectLights::none && draws[d].draw_class() != DrawClass::opaque ? blended : order;
        if (own != ObjectLights::none && draws[d].visible && !(draws[d].features & FEATURE_UNLIT))
            for (size_t i = 0; i < sorted.size(); ++i)
                if (reaches(volumes[i], draws[d]))
                    strongest.emplace_back(
                        own == ObjectLights::strongest_first ? -strength(lights[sorted[i]], draws[d]) : 0.0, sorted[i]);
        if (own == ObjectLights::strongest_first)
            std::sort(strongest.begin(), strongest.end());
        for (const auto& [_, light] : strongest)
            reach.lights.push_back(light);
        reach.first[d + 1] = static_cast<uint32_t>(reach.lights.size());
    }
    return reach;
}

} // namespace prelight::resident
