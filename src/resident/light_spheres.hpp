#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <prelight/scene.hpp>
#include <span>
#include <vector>

namespace prelight::resident {

/// A range so large that its inverse is no normal float is none.
inline constexpr float longest_range = 1e18f;

/// Whether the light ends somewhere.
inline bool has_volume(const Light& light) {
    return light.kind != LightKind::directional && light.range < longest_range;
}

/// Where lights are and how far they reach, a list for each number: what a frame looks at of every light, also of those
/// that it leaves out. Whole lights are five times as large, and memory is what 65,536 of them cost.
struct LightSpheres {
    static constexpr double endless = std::numeric_limits<double>::infinity();
    std::vector<double> x, y, z; ///< metres, world space
    std::vector<double> radius;  ///< metres; `endless` without a volume, -endless of a light that is dark

    /// In place of what there was.
    void assign(std::span<const PlacedLight> lights);
    size_t size() const { return radius.size(); }
};

/// What of a view the spheres are held against, all relative to the eye.
struct SphereView {
    std::array<glm::dvec4, 6> planes{}; ///< unit normals; what is visible lies in front of all
    size_t plane_count = 0;
    glm::dvec3 forward{0}; ///< unit vector
    bool perspective = true;
    double across = 1; ///< a quarter of the picture's area at distance 1, square metres
};

/// As many spheres as are tested together.
inline constexpr size_t sphere_batch = 256;
struct SphereBatch {
    double share[sphere_batch];   ///< of the picture that a sphere covers, roughly; 1 where the eye may be in it
    uint32_t shows[sphere_batch]; ///< 0: it is dark, or lies wholly behind one of the planes
};

/// Tests `count` spheres, at most a batch, from number `first` on.
void test_spheres(const LightSpheres& spheres, size_t first, size_t count, const glm::dvec3& eye,
                  const SphereView& view, SphereBatch& out);

} // namespace prelight::resident
