#include "picker.hpp"

#include "object_edits.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace prelight::app::viewer {
namespace {

/// Whether the ray comes into the box nearer than `nearest`.
bool meets(const Ray& ray, const InstanceBox& box, double nearest) {
    double enter = 0, leave = nearest;
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1 / ray.direction[axis];
        double a = (box.low[axis] - ray.origin[axis]) * inverse, b = (box.high[axis] - ray.origin[axis]) * inverse;
        if (std::isnan(a) || std::isnan(b)) // in a plane of the box
            continue;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

/// Möller and Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection", 1997: both faces. The direction need not be
/// of unit length; what comes back counts in it.
std::optional<double> meets(glm::dvec3 origin, glm::dvec3 direction, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0)
        return {};
    const glm::dvec3 from = origin - a;
    const double u = glm::dot(from, p) / determinant;
    const glm::dvec3 q = glm::cross(from, ab);
    const double v = glm::dot(direction, q) / determinant, t = glm::dot(ac, q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && t > 0))
        return {};
    return t;
}

} // namespace

std::optional<Hit> hit_by(const World& world, const Ray& ray) {
    std::optional<Hit> hit;
    double nearest = std::numeric_limits<double>::infinity();
    for (uint32_t i = 0; i < world.instances.size(); ++i) {
        const Instance& instance = world.instances[i];
        if (glm::determinant(instance.transform) == 0 || !meets(ray, box_of(world, instance), nearest))
            continue;
        const glm::dmat4 inverse = glm::inverse(instance.transform);
        const glm::dvec3 origin(inverse * glm::dvec4(ray.origin, 1)), direction(inverse * glm::dvec4(ray.direction, 0));
        for (const Primitive& primitive : world.mesh_of(instance).primitives)
            for (size_t k = 0; k + 2 < primitive.indices.size(); k += 3) {
                const auto corner = [&](size_t c) { return glm::dvec3(primitive.positions[primitive.indices[k + c]]); };
                const auto t = meets(origin, direction, corner(0), corner(1), corner(2));
                if (!t || *t >= nearest)
                    continue;
                nearest = *t;
                hit = Hit{i, *t, ray.origin + *t * ray.direction};
            }
    }
    return hit;
}

std::vector<uint32_t> lights_near(const std::vector<LightEdits::Listed>& lights, const PlacedCamera& camera,
                                  const PicturePoint& point) {
    std::vector<std::pair<double, uint32_t>> by_distance;
    for (const LightEdits::Listed& light : lights) {
        double distance = std::numeric_limits<double>::infinity();
        const auto place = light.placed.light.kind == LightKind::directional
                               ? std::nullopt
                               : projected(camera, light.placed.position, point.aspect);
        if (place)
            distance = std::hypot((place->x - point.x) * point.aspect, place->y - point.y);
        by_distance.emplace_back(distance, light.number);
    }
    std::ranges::stable_sort(by_distance, {}, [](const auto& one) { return one.first; });
    std::vector<uint32_t> numbers;
    for (const auto& [distance, number] : by_distance)
        numbers.push_back(number);
    return numbers;
}

} // namespace prelight::app::viewer
