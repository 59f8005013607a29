// Ambient occlusion by rays against closed forms.
#include "worlds.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace prelight {
namespace {

/// What comes back of ambient light in the picture's middle, in parts of what comes without occlusion.
double visible(const TestWorld& world, const PlacedCamera& camera, double radius) {
    const auto middle = [&](double r) {
        return render_reference(world.world, camera, 9, 9, 0, {.occlusion_radius = r}).linear.at(4, 4).r;
    };
    return middle(radius) / middle(0);
}

TEST(Visibility, UnderAParallelCeiling) {
    TestWorld world;
    world.world.ambient = glm::vec3(1);
    world.add_material({.metallic = 0});
    world.add(square(100));
    world.add(square(100),
              glm::rotate(glm::translate(glm::dmat4(1), {0, 0, 0.5}), 3.14159265358979, glm::dvec3(1, 0, 0)));
    const PlacedCamera camera = front_camera(0.25);
    // A ray at θ meets the ceiling at h / cos θ: ∫ 2 cos θ sin θ (1 − k / cos² θ) dθ where that is below the radius, k
    // = (h / R)².
    for (const double radius : {0.6, 1.0, 3.0}) {
        const double k = 0.25 / (radius * radius);
        EXPECT_NEAR(visible(world, camera, radius), k - k * std::log(k), 0.01) << radius;
    }
    EXPECT_EQ(visible(world, camera, 0.49), 1) << "farther than the radius";
}

TEST(Visibility, OfALonePlaneIsOne) {
    TestWorld world;
    world.world.ambient = glm::vec3(1);
    world.add_material({.metallic = 0});
    world.add(square(100), glm::rotate(glm::dmat4(1), 1.2, glm::dvec3(1, 0, 0)));
    EXPECT_EQ(visible(world, front_camera(5), 2), 1);
}

TEST(Visibility, BeforeAWallIsWhatTheWallHides) {
    TestWorld world;
    world.world.ambient = glm::vec3(1);
    world.add_material({.metallic = 0});
    world.add(square(100));
    world.add(square(1000),
              glm::rotate(glm::translate(glm::dmat4(1), {0.1, 0, 0}), -1.5707963267948966, glm::dvec3(0, 1, 0)));
    // Beside a wall half of the directions end at it, nearly at no distance.
    EXPECT_NEAR(visible(world, front_camera(2), 1000), 0.5, 0.01);
}

} // namespace
} // namespace prelight
