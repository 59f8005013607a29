#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <prelight/framing.hpp>

namespace prelight {
namespace {

/// Vertices that are looked at one by one; beyond it a primitive's box stands for them, as in resolve().
constexpr size_t max_exact_points = size_t(1) << 22;

struct Box {
    glm::dvec3 low{0}, high{0};
    bool empty = true;
};

/// What the framing needs of a primitive: the vertices that a triangle uses.
struct Used {
    std::vector<uint32_t> vertices;
    Box box;
};

Used used_of(const Primitive& primitive) {
    std::vector<bool> seen(primitive.positions.size());
    for (const uint32_t index : primitive.indices)
        seen[index] = true;
    Used used;
    for (uint32_t i = 0; i < seen.size(); ++i) {
        if (!seen[i])
            continue;
        const glm::dvec3 p(primitive.positions[i]);
        used.box =
            used.box.empty ? Box{p, p, false} : Box{glm::min(used.box.low, p), glm::max(used.box.high, p), false};
        used.vertices.push_back(i);
    }
    return used;
}

/// The world's vertices as the camera's axes see them, relative to `centre`.
std::vector<glm::dvec3> points_of(const World& world, const glm::dmat3& axes, glm::dvec3 centre) {
    const glm::dmat3 to_view = glm::transpose(axes);
    std::vector<glm::dvec3> points;
    std::vector<std::vector<Used>> known(world.scene->meshes.size());
    std::vector<std::vector<Used>> known_deformed(world.deformed.size());
    for (const Instance& instance : world.instances) {
        const Mesh& mesh = world.mesh_of(instance);
        std::vector<Used>& used = instance.deformed ? known_deformed[*instance.deformed] : known[instance.mesh];
        if (used.empty())
            for (const Primitive& primitive : mesh.primitives)
                used.push_back(used_of(primitive));
        const auto add = [&](glm::dvec3 p) {
            points.push_back(to_view * (glm::dvec3(instance.transform * glm::dvec4(p, 1)) - centre));
        };
        for (size_t p = 0; p < used.size(); ++p) {
            if (used[p].box.empty)
                continue;
            if (points.size() + used[p].vertices.size() <= max_exact_points) {
                for (const uint32_t i : used[p].vertices)
                    add(glm::dvec3(mesh.primitives[p].positions[i]));
                continue;
            }
            const glm::dvec3 low = used[p].box.low, high = used[p].box.high;
            for (uint32_t i = 0; i < 8; ++i)
                add({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
        }
    }
    return points;
}

/// Where the camera may stand along one axis of the picture when what it sees must stay within a slope k = fit ×
/// tan(angle / 2) on both sides. A point (x, z) is inside when |x − c| ≤ k (d − z) for the camera at (c, d): so c + k d
/// ≥ max(x + k z) and k d − c ≥ max(k z − x). The nearest such place fulfils both with equality.
struct Place {
    double across, distance;
};
Place nearest_place(const std::vector<glm::dvec3>& points, int axis, double k) {
    double right = -std::numeric_limits<double>::infinity(), left = right;
    for (const glm::dvec3& p : points) {
        right = std::max(right, p[axis] + k * p.z);
        left = std::max(left, k * p.z - p[axis]);
    }
    return {0.5 * (right - left), 0.5 * (right + left) / k};
}

/// Where it has to stand across to see the points in the middle from `distance`, which is not below the nearest
/// place's: that is the nearest place of a smaller slope.
double middle_from(const std::vector<glm::dvec3>& points, int axis, double k, double distance) {
    double low = 0, high = k, across = nearest_place(points, axis, k).across;
    for (int i = 0; i < 14; ++i) {
        const double slope = 0.5 * (low + high);
        const Place place = nearest_place(points, axis, slope);
        (place.distance > distance ? low : high) = slope;
        across = place.across;
    }
    return across;
}

glm::dmat3 axes_of(const Framing& framing) {
    constexpr double degree = std::numbers::pi / 180;
    const double azimuth = framing.azimuth * degree, elevation = framing.elevation * degree;
    const glm::dvec3 back(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                          std::cos(azimuth) * std::cos(elevation));
    const glm::dvec3 right(std::cos(azimuth), 0, -std::sin(azimuth));
    return {right, glm::cross(back, right), back};
}

} // namespace

PlacedCamera frame(const World& world, double aspect, const Framing& framing) {
    PlacedCamera placed;
    placed.camera.name = "framed";
    placed.camera.yfov = std::numbers::pi / 6;
    placed.axes = axes_of(framing);
    const glm::dvec3 centre = 0.5 * world.bounds_min + 0.5 * world.bounds_max;
    std::vector<glm::dvec3> points = points_of(world, placed.axes, centre);
    const double tangent = std::tan(placed.camera.yfov / 2);
    const std::array<double, 2> slope{framing.fit * tangent * aspect, framing.fit * tangent};

    double extent = 0, across = 0; // of all, and of what the picture shows of it
    for (const glm::dvec3& p : points) {
        across = std::max({across, std::abs(p.x), std::abs(p.y)});
        extent = std::max({extent, across, std::abs(p.z)});
    }
    if (across <= 1e-9 * extent) { // nothing, a point, or a line that is looked along: as if it were as thick as long
        const double half = extent > 0 ? extent : 0.5;
        for (const double side : {-half, half})
            points.insert(points.end(), {{side, 0, 0}, {0, side, 0}, {0, 0, side}});
    }
    const Place x = nearest_place(points, 0, slope[0]), y = nearest_place(points, 1, slope[1]);
    const double distance = std::max(x.distance, y.distance);
    const glm::dvec3 place(x.distance < distance ? middle_from(points, 0, slope[0], distance) : x.across,
                           y.distance < distance ? middle_from(points, 1, slope[1], distance) : y.across, distance);
    double near = std::numeric_limits<double>::infinity(), far = 0;
    for (const glm::dvec3& p : points) {
        near = std::min(near, distance - p.z);
        far = std::max(far, distance - p.z);
    }
    placed.position = centre + placed.axes * place;
    placed.camera.zfar = 1.5 * far;
    placed.camera.znear = std::max(0.5 * near, 1e-4 * far);
    return placed;
}

} // namespace prelight
