#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <prelight/light_distribution.hpp>
#include <reference/light_tree.hpp>

namespace prelight::reference {
namespace {

constexpr size_t leaf_size = 4;

double attenuation(Falloff falloff, double distance, double range) {
    const double share = distance / range; // 0 for an infinite range
    switch (falloff) {
    case Falloff::linear: return std::clamp(1 - share, 0.0, 1.0);
    case Falloff::quadratic: return std::clamp(1 - share * share, 0.0, 1.0);
    case Falloff::gltf: break;
    }
    const double safe = std::max(distance, 0.01);
    return std::clamp(1 - share * share * share * share, 0.0, 1.0) / (safe * safe);
}

} // namespace

LightTree::LightTree(const World& world, glm::dvec3 origin) {
    LightDistribution::Pictures pictures;
    for (const PlacedLight& placed : world.lights) {
        const Light& light = placed.light;
        const double cos_outer = std::cos(static_cast<double>(light.outer_cone));
        const double cos_inner = std::cos(static_cast<double>(light.inner_cone));
        lights_.push_back({.kind = light.kind,
                           .falloff = light.falloff,
                           .position = placed.position - origin,
                           .direction = glm::normalize(placed.direction),
                           .radiance = glm::dvec3(light.colour) * largest_intensity(light),
                           .range = light.range,
                           .cos_outer = cos_outer,
                           .cone_scale = 1 / std::max(1e-3, cos_inner - cos_outer),
                           .shininess = light.shininess,
                           .casts_shadow = light.casts_shadow,
                           .distribution = {}});
        if (has_distribution(light))
            lights_.back().distribution.emplace(world, placed, pictures);
        const auto index = static_cast<uint32_t>(lights_.size() - 1);
        if (light.kind == LightKind::directional || std::isinf(light.range))
            unbounded_.push_back(index);
        else if (light.range > 0)
            spheres_.push_back({lights_.back().position, double(light.range), index});
    }
    if (!spheres_.empty())
        build(0, spheres_.size());
}

void LightTree::build(size_t begin, size_t end) {
    const size_t self = nodes_.size();
    Node node{spheres_[begin].centre - spheres_[begin].radius, spheres_[begin].centre + spheres_[begin].radius};
    glm::dvec3 low = spheres_[begin].centre, high = low;
    for (size_t i = begin; i < end; ++i) {
        const Sphere& sphere = spheres_[i];
        node.low = glm::min(node.low, sphere.centre - sphere.radius);
        node.high = glm::max(node.high, sphere.centre + sphere.radius);
        low = glm::min(low, sphere.centre);
        high = glm::max(high, sphere.centre);
    }
    nodes_.push_back(node);
    if (end - begin <= leaf_size) {
        nodes_[self].first = static_cast<uint32_t>(begin);
        nodes_[self].count = static_cast<uint32_t>(end - begin);
        return;
    }
    // Halves by number along the longest side of the centres' box; ties fall to the light's index,
    // so that the order never depends on the library's sort.
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const size_t middle = begin + (end - begin) / 2;
    const auto at = [&](size_t i) { return spheres_.begin() + static_cast<ptrdiff_t>(i); };
    std::sort(at(begin), at(end), [axis](const Sphere& a, const Sphere& b) {
        return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.light < b.light;
    });
    build(begin, middle);
    nodes_[self].first = static_cast<uint32_t>(nodes_.size());
    build(middle, end);
}

void LightTree::reach(glm::dvec3 point, std::vector<uint32_t>& found) const {
    found.assign(unbounded_.begin(), unbounded_.end());
    if (nodes_.empty())
        return;
    // Halving by number keeps the tree's height below 32 for any uint32_t count of lights.
    uint32_t stack[64];
    size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const uint32_t index = stack[--depth];
        const Node& node = nodes_[index];
        if (glm::any(glm::lessThan(point, node.low)) || glm::any(glm::greaterThan(point, node.high)))
            continue;
        if (node.count == 0) {
            stack[depth++] = node.first;
            stack[depth++] = index + 1;
            continue;
        }
        for (uint32_t i = node.first; i < node.first + node.count; ++i) {
            const glm::dvec3 offset = spheres_[i].centre - point;
            if (glm::dot(offset, offset) < spheres_[i].radius * spheres_[i].radius)
                found.push_back(spheres_[i].light);
        }
    }
}

Incident LightTree::incident(uint32_t index, glm::dvec3 point, double pixel) const {
    const Prepared& light = lights_[index];
    if (light.kind == LightKind::directional)
        return {-light.direction, light.radiance, std::numeric_limits<double>::infinity(), light.shininess,
                light.casts_shadow};
    const glm::dvec3 offset = light.position - point;
    const double distance = glm::length(offset);
    if (distance == 0) // no direction: a point in the light itself is not lit by it
        return {};
    const glm::dvec3 to_light = offset / distance;
    double factor = attenuation(light.falloff, distance, light.range);
    if (light.kind == LightKind::spot) {
        const double cone =
            std::clamp((glm::dot(-to_light, light.direction) - light.cos_outer) * light.cone_scale, 0.0, 1.0);
        factor *= cone * cone;
    }
    glm::dvec3 radiance = light.radiance * factor;
    if (light.distribution)
        radiance *= light.distribution->factor(-to_light, pixel / distance);
    return {to_light, radiance, distance, light.shininess, light.casts_shadow};
}

} // namespace prelight::reference
