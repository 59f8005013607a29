// The cameras of `prelight view`: where a drag or a wheel takes them.
#include <cmath>
#include <gmock/gmock.h>
#include <prelight/scene_io.hpp>
#include <view/camera_rig.hpp>
#include <view/picker.hpp>

namespace prelight::test {
namespace {

using namespace app::viewer;

Rig some_rig() {
    Rig rig;
    rig.camera = look_at({}, {3, 2, 5}, {0, 1, 0});
    rig.distance = 4;
    return rig;
}

double off_orthonormal(const glm::dmat3& axes) {
    const glm::dmat3 product = glm::transpose(axes) * axes;
    double off = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            off = std::max(off, std::abs(product[i][k] - (i == k)));
    return off;
}

TEST(ViewCamera, AnOrbitKeepsThePivotAndTheDistance) {
    Rig rig = some_rig();
    const glm::dvec3 pivot = rig.pivot();
    for (int i = 0; i < 500; ++i)
        rig = orbited(rig, 0.07, i % 3 ? 0.05 : -0.11);
    EXPECT_LT(glm::length(rig.pivot() - pivot), 1e-9);
    EXPECT_LT(off_orthonormal(rig.camera.axes), 1e-12);
    EXPECT_NEAR(rig.camera.axes[0].y, 0, 1e-9) << "the horizon stays level";
}

TEST(ViewCamera, ItDoesNotTipOver) {
    const Rig up = orbited(some_rig(), 0, 10), down = orbited(some_rig(), 0, -10);
    EXPECT_GT(up.camera.axes[1].y, 0);
    EXPECT_GT(down.camera.axes[1].y, 0);
    EXPECT_GT(up.forward().y, 0.99);
    EXPECT_LT(down.forward().y, -0.99);
}

TEST(ViewCamera, WhatIsUnderTheCursorStaysThere) {
    const Rig rig = some_rig();
    const PicturePoint cursor{0.4, -0.3, 1.7};
    const Ray ray = ray_through(rig.camera, cursor);
    // On the plane through the pivot, across the camera's axis.
    const glm::dvec3 point = ray.origin + ray.direction * (rig.distance / glm::dot(ray.direction, rig.forward()));
    for (const double notches : {3.0, -2.0}) {
        const Rig next = dollied(rig, notches, cursor);
        const auto seen = projected(next.camera, point, cursor.aspect);
        ASSERT_TRUE(seen);
        EXPECT_NEAR(seen->x, cursor.x, 1e-9);
        EXPECT_NEAR(seen->y, cursor.y, 1e-9);
        EXPECT_NEAR(next.distance, rig.distance * std::pow(0.9, notches), 1e-9);
    }
}

TEST(ViewCamera, APanMovesThePivotWithTheMouse) {
    const Rig rig = some_rig();
    const Rig next = panned(rig, 0.25, 0.1);
    const auto seen = projected(next.camera, rig.pivot(), 1);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->y, -0.2, 1e-9);
    EXPECT_NEAR(seen->x, -0.5, 1e-9);
}

TEST(ViewCamera, ARayMeetsWhatIsInFront) {
    const Scene scene = make_scene("spheres", 1, 1);
    const World world = resolve(scene);
    const auto hit = hit_by(world, {{0.6, 0.7, 20}, {0, 0, -1}}); // the sphere in the lowest row, right of the middle
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 19.5, 1e-2);
    EXPECT_THAT(scene.nodes[world.instances[hit->instance].node].name, testing::HasSubstr("metallic 0.00"));
    EXPECT_FALSE(hit_by(world, {{0, 100, 20}, {0, 0, -1}}));
}

} // namespace
} // namespace prelight::test
