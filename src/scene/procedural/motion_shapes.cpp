#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <scene/procedural/motion_shapes.hpp>

namespace prelight {
namespace {

struct Point {
    glm::dvec3 place{0}, normal{0};
};

/// Distance 0.55 + 0.9 · (x⁴ + y⁴ + z⁴) from the middle in direction (x, y, z).
Point star(const glm::dvec3& d) {
    const glm::dvec3 cubes = d * d * d;
    const double distance = 0.55 + 0.9 * glm::dot(cubes, d);
    const glm::dvec3 gradient = 3.6 * cubes;
    const glm::dvec3 along = gradient - d * glm::dot(gradient, d);
    return {distance * d, glm::normalize(distance * d - along)};
}

Point egg(const glm::dvec3& d) {
    const glm::dvec3 size(0.7, 1.5, 0.7);
    return {size * d, glm::normalize(d / size)};
}

MorphTarget target(const Primitive& sphere, Point (*shape)(const glm::dvec3&)) {
    MorphTarget out;
    for (const glm::vec3& direction : sphere.positions) {
        const glm::dvec3 d = glm::normalize(glm::dvec3(direction));
        const Point point = shape(d);
        out.positions.emplace_back(point.place - d);
        out.normals.emplace_back(point.normal - d);
    }
    return out;
}

/// The two joints next to a place along the column, in joints' distances, and their weights.
void follow(JointSet& set, double along, uint32_t joints) {
    const double place = std::clamp(along - 0.5, 0.0, double(joints - 1));
    const auto lower = std::min(static_cast<uint32_t>(place), joints - 2);
    const double t = place - lower;
    const auto upper_weight = static_cast<float>(t * t * (3 - 2 * t));
    set.joints.emplace_back(lower, lower + 1, 0, 0);
    set.weights.emplace_back(1 - upper_weight, upper_weight, 0, 0);
    for (int i = 0; i < 2; ++i) // what nothing follows names no joint
        if (set.weights.back()[i] == 0)
            set.joints.back()[i] = 0;
}

} // namespace

Primitive make_morphing_sphere(uint32_t slices, uint32_t stacks) {
    Primitive sphere = make_sphere(1, slices, stacks);
    sphere.morph_targets = {target(sphere, star), target(sphere, egg)};
    return sphere;
}

Primitive make_jointed_column(float radius, float height, uint32_t joints) {
    constexpr uint32_t slices = 32;
    const uint32_t rings = 8 * joints;
    Primitive column;
    JointSet& set = column.joint_sets.emplace_back();
    const auto add = [&](double y, double angle, double from_axis, glm::vec3 normal, glm::vec2 uv) {
        column.positions.emplace_back(from_axis * std::cos(angle), y, -from_axis * std::sin(angle));
        column.normals.push_back(normal);
        column.texcoords[0].push_back(uv);
        follow(set, y / double(height) * joints, joints);
    };
    const auto angle_of = [](uint32_t slice) { return 2 * std::numbers::pi * slice / slices; };
    for (uint32_t ring = 0; ring <= rings; ++ring)
        for (uint32_t slice = 0; slice <= slices; ++slice) {
            const double share = double(ring) / rings, angle = angle_of(slice);
            add(share * double(height), angle, double(radius), glm::vec3(std::cos(angle), 0, -std::sin(angle)),
                {float(slice) / slices, float(1 - share)});
        }
    for (uint32_t ring = 0; ring < rings; ++ring)
        for (uint32_t slice = 0; slice < slices; ++slice) {
            const uint32_t a = ring * (slices + 1) + slice, b = a + slices + 1;
            column.indices.insert(column.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    const auto rim = static_cast<uint32_t>(column.positions.size());
    for (uint32_t slice = 0; slice < slices; ++slice)
        add(double(height), angle_of(slice), double(radius), {0, 1, 0}, {float(slice) / slices, 0});
    const auto middle = static_cast<uint32_t>(column.positions.size());
    add(double(height), 0, 0, {0, 1, 0}, {0.5f, 0});
    for (uint32_t slice = 0; slice < slices; ++slice)
        column.indices.insert(column.indices.end(), {middle, rim + slice, rim + (slice + 1) % slices});
    return column;
}

} // namespace prelight
