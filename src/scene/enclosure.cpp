#include "enclosure.hpp"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace prelight {
namespace {

constexpr uint64_t max_triangles = 4'000'000;
constexpr double smallest_room = 3; ///< metres
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Ray {
    glm::dvec3 origin{0}, direction{0};
    double distance = infinity;
    bool front = false;
};

/// Möller and Trumbore 1997; keeps the nearest hit.
void intersect(Ray& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, bool mirrored, bool double_sided) {
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0)
        return;
    const glm::dvec3 t = ray.origin - a;
    const double u = glm::dot(t, p) / determinant;
    const glm::dvec3 q = glm::cross(t, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    const double distance = glm::dot(ac, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1 || distance <= 0 || distance >= ray.distance)
        return;
    ray.distance = distance;
    ray.front = double_sided || (determinant > 0) != mirrored;
}

void cast(const World& world, std::vector<Ray>& rays) {
    for (const Instance& instance : world.instances)
        for (const Primitive& primitive : world.mesh_of(instance).primitives) {
            const bool double_sided = world.scene->materials[primitive.material].double_sided;
            const auto corner = [&](size_t i) {
                return glm::dvec3(instance.transform * glm::dvec4(primitive.positions[primitive.indices[i]], 1));
            };
            for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
                const glm::dvec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
                for (Ray& ray : rays)
                    intersect(ray, a, b, c, instance.mirrored, double_sided);
            }
        }
}

/// Directions up to 27° above the horizon and down: eight around, at five slopes.
std::vector<Ray> probes(glm::dvec3 middle) {
    std::vector<Ray> rays;
    for (const double slope : {0.5, 0.15, -0.05, -0.3, -0.8})
        for (int i = 0; i < 8; ++i) {
            const double angle = 0.785398163 * i + 0.1;
            rays.push_back({middle, glm::normalize(glm::dvec3(std::cos(angle), slope, std::sin(angle)))});
        }
    return rays;
}

/// Whether most of the world's primitives have their middle in a 16:9 picture of this camera.
bool sees_most(const World& world, const PlacedCamera& placed) {
    const double half = std::tan(placed.camera.yfov / 2);
    size_t all = 0, seen = 0;
    for (const Instance& instance : world.instances)
        for (const Primitive& primitive : world.mesh_of(instance).primitives) {
            if (primitive.positions.empty())
                continue;
            glm::vec3 low = primitive.positions[0], high = low;
            for (const glm::vec3& p : primitive.positions) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
            const glm::dvec3 middle(instance.transform * glm::dvec4(0.5 * glm::dvec3(low) + 0.5 * glm::dvec3(high), 1));
            const glm::dvec3 view = glm::transpose(placed.axes) * (middle - placed.position);
            ++all;
            if (view.z < 0 && std::abs(view.y) < -view.z * half && std::abs(view.x) < -view.z * half * 16 / 9)
                ++seen;
        }
    return seen * 2 >= all;
}

} // namespace

std::optional<PlacedCamera> camera_inside(const World& world) {
    const glm::dvec3 extent = world.bounds_max - world.bounds_min;
    if (std::min({extent.x, extent.y, extent.z}) < smallest_room || world.triangles > max_triangles)
        return {};
    const glm::dvec3 middle = 0.5 * world.bounds_min + 0.5 * world.bounds_max;
    std::vector<Ray> rays = probes(middle);
    cast(world, rays);
    const auto fronts = std::count_if(rays.begin(), rays.end(), [](const Ray& ray) { return ray.front; });
    if (static_cast<size_t>(fronts) * 10 < rays.size() * 9)
        return {};

    std::vector<Ray> floor{{middle, {0, -1, 0}}};
    cast(world, floor);
    if (!floor[0].front)
        return {};
    const double height = std::min(1.7, 0.4 * extent.y);
    const glm::dvec3 eye_level(middle.x, middle.y - floor[0].distance + height, middle.z);
    std::vector<Ray> ways;
    for (const glm::dvec3& way : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)})
        ways.push_back({eye_level, way});
    cast(world, ways);
    for (Ray& way : ways)
        way.distance = std::min(way.distance, glm::length(extent));
    const bool along_x = ways[0].distance + ways[1].distance >= ways[2].distance + ways[3].distance;
    const Ray &ahead = ways[along_x ? 0 : 2], &behind = ways[along_x ? 1 : 3];
    Camera camera;
    camera.name = "inside";
    camera.yfov = 1.0;
    camera.znear = 0.05;
    const glm::dvec3 eye = eye_level + behind.direction * (0.85 * behind.distance);
    const glm::dvec3 target = eye_level + ahead.direction * ahead.distance + glm::dvec3(0, 0.5 * height, 0);
    const PlacedCamera inside = look_at(camera, eye, target);
    return sees_most(world, inside) ? std::optional(inside) : std::nullopt;
}

} // namespace prelight
