#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <prelight/scene.hpp>
#include <vector>

namespace prelight {

/// Two triangles that lie on each other and face the same way: which of them is seen is a matter
/// of rounding (z-fighting).
struct CoplanarPair {
    struct Face {
        uint32_t instance = 0;  ///< index into World::instances
        uint32_t primitive = 0; ///< of the instance's mesh
        uint32_t triangle = 0;  ///< of the primitive
        auto operator<=>(const Face&) const = default;
    };
    Face a, b;           ///< a < b
    double area = 0;     ///< m² where they overlap and lie less than the tolerance apart
    glm::dvec3 point{0}; ///< middle of that area, world space
    glm::dvec3 normal{0};
};

/// Every pair of triangles of `world` whose normals differ by less than 0.5° and which, seen along
/// them, overlap by more than `min_area` (m²) where they are less than `distance` (m) apart.
/// Triangles of the same primitive of the same instance count only when their vertex colours
/// differ; those that face opposite ways never do, but for materials that are double-sided.
std::vector<CoplanarPair> find_coplanar(const World& world, double distance = 1e-3, double min_area = 1e-4);

} // namespace prelight
