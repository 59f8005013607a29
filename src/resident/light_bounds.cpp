#include "light_bounds.hpp"
#include "lights.hpp"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace prelight::resident {
namespace {

using glm::dvec2, glm::dvec3;

/// As light_volume.vert: rounding takes nothing of the volume away.
constexpr double larger = 1.001;
constexpr double apex_back = 0.0005;

/// BoundsView space here: x right, y up, z forward.
struct BoundsView {
    bool perspective;
    double near, far;
    double scale_x, scale_y; ///< clip per tangent (perspective) or per metre

    bool holds(double z) const { return z >= near && z <= far; }
    /// One axis of a point's place on the screen, before scaling.
    double project(double across, double z) const { return perspective ? across / z : across; }
};

/// The part of a disc between the planes, seen along its plane; (across, z).
Interval project_disc(const BoundsView& view, dvec2 centre, double radius) {
    Interval out;
    const auto add = [&](dvec2 p) {
        if (view.holds(p.y))
            out.add(view.project(p.x, p.y));
    };
    const double distance2 = glm::dot(centre, centre), tangent2 = distance2 - radius * radius;
    if (!view.perspective) {
        add(centre - dvec2(radius, 0));
        add(centre + dvec2(radius, 0));
    } else if (tangent2 > 0) { // else the eye is in the disc, and the near plane cuts it
        const dvec2 along = centre * (tangent2 / distance2);
        const dvec2 aside = dvec2(-centre.y, centre.x) * (radius * std::sqrt(tangent2) / distance2);
        add(along - aside);
        add(along + aside);
    }
    for (const double plane : {view.near, view.far}) {
        const double height = plane - centre.y;
        if (!(std::abs(height) < radius))
            continue;
        const double half = std::sqrt(radius * radius - height * height);
        add({centre.x - half, plane});
        add({centre.x + half, plane});
    }
    return out;
}

/// A sector of a sphere: what a spot reaches.
struct Sector {
    dvec3 apex{0}, axis{0};
    double range, angle;
    dvec3 rim_centre() const { return apex + axis * (range * std::cos(angle)); }
    double rim_radius() const { return range * std::sin(angle); }
    /// A vector from the apex to the sphere ends in the cap.
    bool in_cap(dvec3 offset) const { return glm::dot(offset, axis) >= range * std::cos(angle); }
};

Interval depth_of(const Sector& s) {
    Interval out;
    const double tilt = s.rim_radius() * std::sqrt(std::max(0.0, 1 - s.axis.z * s.axis.z));
    for (const double z : {s.apex.z, s.rim_centre().z - tilt, s.rim_centre().z + tilt})
        out.add(z);
    for (const double pole : {-s.range, s.range})
        if (s.in_cap({0, 0, pole}))
            out.add(s.apex.z + pole);
    return out;
}

/// One axis (0: x, 1: y) of a sector that lies wholly before the eye.
Interval project_sector(const BoundsView& view, const Sector& s, int axis) {
    const auto flat = [axis](dvec3 p) { return dvec2(p[axis], p.z); };
    Interval out;
    const dvec2 apex = flat(s.apex), c = flat(s.rim_centre()), a = flat(s.axis);
    const double rho2 = s.rim_radius() * s.rim_radius();
    out.add(view.project(apex.x, apex.y));
    if (!view.perspective) {
        const double half = std::sqrt(rho2 * std::max(0.0, 1 - a.x * a.x));
        out.add(c.x - half);
        out.add(c.x + half);
        for (const double pole : {-s.range, s.range}) {
            dvec3 offset(0);
            offset[axis] = pole;
            if (s.in_cap(offset))
                out.add(apex.x + pole);
        }
        return out;
    }
    // The plane across = m·z through the eye touches the circle where the distance of the circle's
    // centre is the circle's support along the plane's normal (1, −m): a quadratic in m.
    const double qa = c.y * c.y - rho2 * (1 - a.y * a.y), qb = c.x * c.y + rho2 * a.x * a.y,
                 qc = c.x * c.x - rho2 * (1 - a.x * a.x);
    const double root = std::sqrt(std::max(0.0, qb * qb - qa * qc));
    out.add((qb - root) / qa);
    out.add((qb + root) / qa);
    // Where the sphere's own tangents touch the cap.
    const double distance2 = glm::dot(apex, apex), tangent2 = distance2 - s.range * s.range;
    if (tangent2 > 0)
        for (const double sign : {-1.0, 1.0}) {
            const dvec2 touch = apex * (tangent2 / distance2) +
                                dvec2(-apex.y, apex.x) * (sign * s.range * std::sqrt(tangent2) / distance2);
            dvec3 offset(0, 0, touch.y - apex.y);
            offset[axis] = touch.x - apex.x;
            if (s.in_cap(offset))
                out.add(view.project(touch.x, touch.y));
        }
    return out;
}

/// Both axes of a sector that the near plane cuts: the corners of a polyhedron around it, and the
/// points where its edges meet the plane.
void project_cut_sector(const BoundsView& view, const Sector& s, Interval& x, Interval& y) {
    constexpr int sides = 24, rings = 4;
    const dvec3 helper = std::abs(s.axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
    const dvec3 side = glm::normalize(glm::cross(s.axis, helper)), up = glm::cross(s.axis, side);
    const double pi = 3.14159265358979323846, outward = 1 / std::cos(pi / sides);
    // From the rim inwards: planes that touch the sphere between two rings.
    const double step = s.angle / rings;
    const auto point = [&](int ring, int i) {
        const double angle = ring == 0 ? s.angle : s.angle - (ring - 0.5) * step;
        const double length = s.range * (ring == 0 ? 1 : 1 / std::cos(step / 2));
        const double turn = 2 * pi * i / sides;
        return s.apex + s.axis * (length * std::cos(angle)) +
               (side * std::cos(turn) + up * std::sin(turn)) * (length * std::sin(angle) * outward);
    };
    const auto add = [&](dvec3 p) {
        x.add(view.project(p.x, p.z));
        y.add(view.project(p.y, p.z));
    };
    const auto edge = [&](dvec3 a, dvec3 b) {
        for (const dvec3& p : {a, b})
            if (p.z >= view.near)
                add(p);
        if ((a.z < view.near) != (b.z < view.near)) {
            dvec3 p = a + (b - a) * ((view.near - a.z) / (b.z - a.z));
            p.z = view.near;
            add(p);
        }
    };
    for (int i = 0; i < sides; ++i) {
        edge(s.apex, point(0, i));
        for (int ring = 0; ring <= rings; ++ring) {
            edge(point(ring, i), point(ring, i + 1));
            if (ring < rings)
                edge(point(ring, i), point(ring + 1, i));
        }
    }
}

} // namespace

void Interval::add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
}

void Interval::cut(const Interval& other) {
    low = std::max(low, other.low);
    high = std::min(high, other.high);
}

bool ScreenBounds::empty() const {
    const auto misses = [](const Interval& i) { return i.empty() || i.low > 1 || i.high < -1; };
    return misses(x) || misses(y) || depth.empty();
}

ScreenBoundsOf::ScreenBoundsOf(const PlacedCamera& camera, double aspect) : camera_(camera) {
    const Camera& lens = camera.camera;
    const double half_height = lens.kind == ProjectionKind::perspective ? std::tan(lens.yfov / 2) : lens.ymag;
    scale_x_ = 1 / (half_height * aspect);
    scale_y_ = 1 / half_height;
}

ScreenBounds ScreenBoundsOf::operator()(const PlacedLight& placed) const {
    const PlacedCamera& camera = camera_;
    const Camera& lens = camera.camera;
    const BoundsView view{lens.kind == ProjectionKind::perspective, lens.znear, lens.zfar, scale_x_, scale_y_};
    const auto into_view = [&](dvec3 v) {
        const dvec3 turned = v * camera.axes; // dots with the axes
        return dvec3(turned.x, turned.y, -turned.z);
    };
    const dvec3 centre = into_view(placed.position - camera.position);
    const double range = placed.light.range * larger;

    ScreenBounds out;
    out.x = project_disc(view, {centre.x, centre.z}, range);
    out.y = project_disc(view, {centre.y, centre.z}, range);
    out.depth = {centre.z - range, centre.z + range};
    if (is_cone(placed.light)) {
        const dvec3 axis = into_view(placed.direction);
        const Sector sector{centre - axis * (range * apex_back), axis, range * (1 + apex_back),
                            placed.light.outer_cone};
        const Interval depth = depth_of(sector);
        Interval x, y;
        if (depth.low > view.near) {
            x = project_sector(view, sector, 0);
            y = project_sector(view, sector, 1);
        } else {
            project_cut_sector(view, sector, x, y);
        }
        out.x.cut(x);
        out.y.cut(y);
        out.depth.cut(depth);
    }
    out.depth.cut({view.near, view.far});
    out.x = {out.x.low * view.scale_x, out.x.high * view.scale_x};
    out.y = {-out.y.high * view.scale_y, -out.y.low * view.scale_y};
    return out;
}

shared::LightScreenBounds light_bounds(const ScreenBounds& bounds, const shared::FrameConstants& constants,
                                       VkExtent2D extent) {
    // Vertices snap to a sixteenth of a pixel or finer, and float clip space is as coarse in pictures
    // of thousands of pixels.
    const double pad_x = 0.125 / extent.width, pad_y = 0.125 / extent.height;
    const auto device_depth = [&](double z, double sign) {
        const double w = double(constants.forward.w) > 0.5 ? z : 1.0;
        const double offset = constants.depth.y, slope = constants.depth.x;
        const double limit = std::isinf(z) ? 0.0 : (offset - slope * z) / w; // clip.z over clip.w
        const double rounding = std::isinf(z) ? 0.0 : 1e-6 * (offset + slope * z) / w;
        return std::clamp(limit + sign * rounding, 0.0, 1.0);
    };
    shared::LightScreenBounds out{};
    out.rectangle = glm::vec4(std::max(-1.0, bounds.x.low - pad_x), std::max(-1.0, bounds.y.low - pad_y),
                              std::min(1.0, bounds.x.high + pad_x), std::min(1.0, bounds.y.high + pad_y));
    out.depth = glm::vec4(device_depth(bounds.depth.low, 1), device_depth(bounds.depth.high, -1), 0, 0);
    return out;
}

} // namespace prelight::resident
