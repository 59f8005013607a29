#include "camera_rig.hpp"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <prelight/framing.hpp>

namespace prelight::app::viewer {
namespace {

constexpr double steepest = 89.5 * std::numbers::pi / 180; // of the camera's axis
constexpr double step_of_notch = 0.9;

glm::dmat3 turn(double angle, glm::dvec3 axis) { return glm::dmat3(glm::rotate(glm::dmat4(1), angle, axis)); }

/// Columns that have drifted by rounding, unit and at right angles again.
glm::dmat3 orthonormal(const glm::dmat3& axes) {
    const glm::dvec3 back = glm::normalize(axes[2]);
    const glm::dvec3 right = glm::normalize(glm::cross(axes[1], back));
    return {right, glm::cross(back, right), back};
}

double elevation(const Rig& rig) { return std::asin(std::clamp(rig.forward().y, -1.0, 1.0)); }

/// Half the picture's height at the pivot's distance, metres.
double half_height(const Rig& rig) {
    const Camera& camera = rig.camera.camera;
    return camera.kind == ProjectionKind::perspective ? rig.distance * std::tan(camera.yfov / 2) : camera.ymag;
}

/// The axes' turn; `pitch` is cut so that up stays up.
glm::dmat3 turned(const Rig& rig, double yaw, double pitch) {
    const double now = elevation(rig);
    const double most = std::max(steepest, std::abs(now)); // a camera that looks straight down may
    const double next = std::clamp(now + pitch, -most, most);
    return turn(yaw, {0, 1, 0}) * turn(next - now, rig.camera.axes[0]);
}

} // namespace

Rig rig_of(const PlacedCamera& camera, const World& world) {
    Rig rig{camera, 1};
    const glm::dvec3 centre = (world.bounds_min + world.bounds_max) * 0.5;
    const double size = std::max(glm::length(world.bounds_max - world.bounds_min), 1e-3);
    const double ahead = glm::dot(centre - camera.position, rig.forward());
    rig.distance = std::max(ahead, size / 10);
    return rig;
}

Rig framed(const Rig& rig, const World& world, double aspect) {
    Framing framing;
    const glm::dvec3 from = rig.camera.axes[2];
    framing.azimuth = std::atan2(from.x, from.z) * 180 / std::numbers::pi;
    framing.elevation = std::asin(std::clamp(from.y, -1.0, 1.0)) * 180 / std::numbers::pi;
    const PlacedCamera whole = frame(world, aspect, framing);
    return rig_of(whole, world);
}

Rig orbited(const Rig& rig, double yaw, double pitch) {
    Rig next = rig;
    next.camera.previous.reset();
    const glm::dvec3 pivot = rig.pivot();
    next.camera.axes = orthonormal(turned(rig, yaw, pitch) * rig.camera.axes);
    next.camera.position = pivot - next.distance * next.forward();
    return next;
}

Rig looked(const Rig& rig, double yaw, double pitch) {
    Rig next = rig;
    next.camera.previous.reset();
    next.camera.axes = orthonormal(turned(rig, yaw, pitch) * rig.camera.axes);
    return next;
}

Rig panned(const Rig& rig, double right, double up) {
    Rig next = rig;
    next.camera.previous.reset();
    next.camera.position += 2 * half_height(rig) * (right * rig.camera.axes[0] + up * rig.camera.axes[1]);
    return next;
}

Rig dollied(const Rig& rig, double notches, const PicturePoint& to) {
    Rig next = rig;
    next.camera.previous.reset();
    const bool parallel = rig.camera.camera.kind == ProjectionKind::orthographic;
    const double size = parallel ? double(rig.camera.camera.ymag) : rig.distance;
    const double left = std::clamp(size * std::pow(step_of_notch, notches), 1e-6, 1e9) / size; // of the way
    const double half = half_height(rig);
    const glm::dvec3 aside = half * (to.x * to.aspect * rig.camera.axes[0] + to.y * rig.camera.axes[1]);
    if (parallel) {
        next.camera.camera.ymag *= left;
        next.camera.position += (1 - left) * aside;
        return next;
    }
    next.distance = rig.distance * left;
    next.camera.position += (1 - left) * (aside + rig.distance * rig.forward());
    return next;
}

Rig flown(const Rig& rig, glm::dvec3 metres) {
    Rig next = rig;
    next.camera.previous.reset();
    next.camera.position += metres.x * rig.camera.axes[0] + glm::dvec3(0, metres.y, 0) + metres.z * rig.forward();
    return next;
}

Ray ray_through(const PlacedCamera& camera, const PicturePoint& point) {
    const glm::dvec3 forward = -camera.axes[2];
    if (camera.camera.kind == ProjectionKind::orthographic)
        return {camera.position +
                    camera.camera.ymag * (point.x * point.aspect * camera.axes[0] + point.y * camera.axes[1]),
                forward};
    const double half = std::tan(camera.camera.yfov / 2);
    return {camera.position,
            glm::normalize(forward + half * (point.x * point.aspect * camera.axes[0] + point.y * camera.axes[1]))};
}

std::optional<PicturePoint> projected(const PlacedCamera& camera, glm::dvec3 world, double aspect) {
    const glm::dvec3 seen = glm::transpose(camera.axes) * (world - camera.position);
    if (-seen.z < 1e-6)
        return {};
    const double half = camera.camera.kind == ProjectionKind::perspective ? -seen.z * std::tan(camera.camera.yfov / 2)
                                                                          : camera.camera.ymag;
    return PicturePoint{seen.x / (half * aspect), seen.y / half, aspect};
}

} // namespace prelight::app::viewer
