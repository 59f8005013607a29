#include "volume_meshes.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace prelight::passes {
namespace {

constexpr double pi = 3.14159265358979323846;

VolumeMesh icosahedron() {
    const float g = (1 + std::sqrt(5.0f)) / 2;
    VolumeMesh mesh;
    for (const glm::vec3& p : {glm::vec3(-1, g, 0), glm::vec3(1, g, 0), glm::vec3(-1, -g, 0), glm::vec3(1, -g, 0),
                               glm::vec3(0, -1, g), glm::vec3(0, 1, g), glm::vec3(0, -1, -g), glm::vec3(0, 1, -g),
                               glm::vec3(g, 0, -1), glm::vec3(g, 0, 1), glm::vec3(-g, 0, -1), glm::vec3(-g, 0, 1)})
        mesh.points.push_back(glm::normalize(p));
    mesh.indices = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
                    3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
    return mesh;
}

VolumeMesh subdivide(const VolumeMesh& coarse) {
    VolumeMesh fine{coarse.points, {}};
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
        const auto [it, added] = middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(fine.points.size()));
        if (added)
            fine.points.push_back(glm::normalize(coarse.points[a] + coarse.points[b]));
        return it->second;
    };
    for (size_t i = 0; i < coarse.indices.size(); i += 3) {
        const uint32_t a = coarse.indices[i], b = coarse.indices[i + 1], c = coarse.indices[i + 2];
        const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const uint32_t v : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca})
            fine.indices.push_back(v);
    }
    return fine;
}

/// Distance from the origin to the nearest face's plane.
float inscribed_radius(const VolumeMesh& mesh) {
    float radius = 1;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.points[mesh.indices[i]], b = mesh.points[mesh.indices[i + 1]],
                        c = mesh.points[mesh.indices[i + 2]];
        radius = std::min(radius, glm::dot(glm::normalize(glm::cross(b - a, c - a)), a));
    }
    return radius;
}

} // namespace

VolumeMesh sphere_volume() {
    VolumeMesh mesh = subdivide(icosahedron());
    const float radius = inscribed_radius(mesh);
    for (glm::vec3& p : mesh.points)
        p /= radius;
    return mesh;
}

VolumeMesh cone_volume(uint32_t sides) {
    // A polygon whose edges touch the unit circle.
    const double outward = 1 / std::cos(pi / sides);
    VolumeMesh mesh;
    mesh.points.push_back({0, 0, 0});
    mesh.points.push_back({0, 0, 3});
    for (uint32_t ring : {1u, 2u})
        for (uint32_t i = 0; i < sides; ++i) {
            const double a = 2 * pi * i / sides;
            mesh.points.push_back({outward * std::cos(a), outward * std::sin(a), ring});
        }
    // light_volume.vert takes the frame (side, axis × side, axis), which is right-handed.
    for (uint32_t i = 0; i < sides; ++i) {
        const uint32_t next = (i + 1) % sides, rim = 2, cap = 2 + sides;
        for (const uint32_t v : {0u, rim + next, rim + i, rim + i, rim + next, cap + i, rim + next, cap + next, cap + i,
                                 1u, cap + i, cap + next})
            mesh.indices.push_back(v);
    }
    return mesh;
}

VolumeMesh box_volume() {
    VolumeMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.points.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : 0});
    mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return mesh;
}

} // namespace prelight::passes
