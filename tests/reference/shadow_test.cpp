#include "worlds.hpp"
#include <gtest/gtest.h>

namespace prelight {
namespace {

const ReferenceForm with_shadows{.shadows = true};

TEST(Shadows, OfASquareLiesWhereTheRaysSay) {
    TestWorld test;
    test.add_material({.metallic = 0});
    test.add(square(10));
    // A square of 0.4 m at height 1 under a light at height 2 shadows twice its size. The camera is
    // above both: the blocker is 2 m in front of it, and hides a part of the shadow's middle.
    test.add(square(0.2f), glm::translate(glm::dmat4(1), {0, 0, 1}));
    test.add_light({.intensity = 10}, {0, 0, 2});
    const uint32_t size = 200;
    const auto lit = render_reference(test.world, front_camera(3), size, size, 0, {});
    const auto shadowed = render_reference(test.world, front_camera(3), size, size, 0, with_shadows);
    uint32_t dark = 0;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const size_t i = size_t(y) * size + x;
            const double reach = std::max(std::abs(shadowed.position[i].x), std::abs(shadowed.position[i].y));
            const bool in_shadow = shadowed.instance[i] == 0 && reach < 0.4;
            if (std::abs(reach - 0.4) < 1e-3)
                continue;
            EXPECT_EQ(shadowed.linear.pixels[i], in_shadow ? glm::vec3(0) : lit.linear.pixels[i]) << x << ", " << y;
            EXPECT_EQ(shadowed.shadow_mask[i] != 0, in_shadow);
            EXPECT_EQ(lit.shadow_mask[i], 0u);
            dark += in_shadow;
        }
    EXPECT_GT(dark, 100u);
}

TEST(Shadows, NothingShadowsItself) {
    // Every point of a convex body that faces the light is lit: no acne, near and 10 km away.
    for (const double offset : {0.0, 1e4}) {
        TestWorld test;
        Primitive ball = sphere(32);
        ball.normals.clear(); // flat: where N·L > 0 the triangle itself faces the light
        test.add(ball, glm::translate(glm::dmat4(1), {offset, 0, offset}));
        test.add_light({.kind = LightKind::directional}, {0, 0, 0}, {-0.5, -0.3, -1});
        PlacedCamera camera = front_camera(3);
        camera.position += glm::dvec3(offset, 0, offset);
        const auto picture = render_reference(test.world, camera, 128, 128, 0, with_shadows);
        for (const uint64_t mask : picture.shadow_mask)
            EXPECT_EQ(mask, 0u);
    }
}

TEST(Shadows, PassThroughHolesAndAreCastByBackFaces) {
    for (const bool hole : {false, true}) {
        TestWorld test;
        test.add_material({.metallic = 0});
        test.add(square(1));
        Material masked{.base_colour = {1, 1, 1, hole ? 0.1f : 0.9f}};
        masked.alpha_mode = AlphaMode::mask;
        test.add_material(masked);
        // Out of the camera's sight, its back to the plane's light side.
        test.add(square(5),
                 glm::rotate(glm::translate(glm::dmat4(1), {0, 0, 6}), 3.14159265358979, glm::dvec3(1, 0, 0)));
        test.add_light({.intensity = 100}, {0, 0, 8});
        const auto picture = render_reference(test.world, front_camera(4), 8, 8, 0, with_shadows);
        EXPECT_EQ(picture.linear.at(4, 4).r > 0, hole);
    }
}

TEST(Shadows, WhatLiesBehindTheLightCastsNone) {
    TestWorld test;
    test.add(square(1));
    test.add(square(5), glm::translate(glm::dmat4(1), {0, 0, 6}));
    test.add_light({.intensity = 100}, {0, 0, 5});
    const auto picture = render_reference(test.world, front_camera(4), 8, 8, 0, with_shadows);
    EXPECT_GT(picture.linear.at(4, 4).r, 0);
}

} // namespace
} // namespace prelight
