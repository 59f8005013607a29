#include "sequence/turntable.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>
#include <scene/enclosure.hpp>

namespace prelight::app {
namespace {

/// Of what is in view from there, the nearest and farthest depth that anything may have on the way round.
std::pair<double, double> depths_round(const World& world, const PlacedCamera& camera, glm::dvec3 centre) {
    const glm::dvec3 half = 0.5 * (world.bounds_max - world.bounds_min), back = camera.axes[2];
    const double radius = std::hypot(half.x, half.z);
    const double to_centre = glm::dot(back, camera.position - centre);
    const double reach = radius * std::hypot(back.x, back.z) + half.y * std::abs(back.y);
    return {to_centre - reach, to_centre + reach};
}

/// A camera in a room or a street: its way round the centre would lead through walls.
bool is_inside(const World& world, const glm::dvec3& position) {
    return glm::all(glm::greaterThan(position, world.bounds_min)) &&
           glm::all(glm::lessThan(position, world.bounds_max)) && camera_inside(world);
}

} // namespace

Turntable::Turntable(const World& world, const PlacedCamera& start, double seconds, bool widen)
    : start_(start), centre_(0.5 * world.bounds_min + 0.5 * world.bounds_max), seconds_(seconds) {
    start_.previous = {};
    if (is_inside(world, start.position)) {
        centre_ = start.position;
        return;
    }
    const auto [nearest, farthest] = depths_round(world, start, centre_);
    if (!widen || farthest <= 0)
        return;
    Camera& camera = start_.camera;
    camera.zfar = std::max(camera.zfar, 1.01 * farthest);
    camera.znear = std::min(camera.znear, std::max(0.5 * nearest, 1e-4 * farthest));
}

CameraPose Turntable::pose_at(double time) const {
    const double rounds = time / seconds_;
    const double angle = 2 * std::numbers::pi * (rounds - std::floor(rounds));
    if (angle == 0)
        return {start_.position, start_.axes};
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dmat3 turn(c, 0, -s, 0, 1, 0, s, 0, c); // columns; +Z goes towards +X
    return {centre_ + turn * (start_.position - centre_), turn * start_.axes};
}

PlacedCamera Turntable::at(double time, double interval) const {
    PlacedCamera camera = start_;
    const CameraPose now = pose_at(time);
    camera.position = now.position;
    camera.axes = now.axes;
    camera.previous = pose_at(time - interval);
    return camera;
}

} // namespace prelight::app
