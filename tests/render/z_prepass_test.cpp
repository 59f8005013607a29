// Z pre-pass forward against the reference; SwiftShader's smoke of both forward
// renderers.
#include "garden.hpp"
#include <prelight/scene_io.hpp>
#include <resident/light_reach.hpp>

namespace prelight {
namespace {

Shot z_prepass(Shot shot, std::map<std::string, std::string> settings = {}) {
    shot.renderer = "z-prepass";
    shot.settings = std::move(settings);
    return shot;
}

// More than eight lights reach most objects: 15, and two that reach everything.
TEST(ZPrepass, EveryFormAgreesWithTheReference) {
    Garden garden;
    garden.add_lights(15, 7, 4);
    garden.add_light({.kind = LightKind::directional, .intensity = 0.4f}, {0, 0, 0}, {-0.3, -1, -0.5});
    garden.add_light(garden.point(std::numeric_limits<float>::infinity(), 4), {0, 4, 3});
    garden.add_light(garden.spot(0.5f, 8, 20), {2, 5, 3}, {-0.3, -1, -0.5});
    expect_agrees(z_prepass(garden.shot()));
    expect_agrees(z_prepass(garden.shot(), {{"model", "nv"}}));
    Shot phong = z_prepass(garden.shot());
    phong.shading = Shading::phong;
    phong.exposure = -2;
    expect_agrees(phong);
    phong.settings = {{"specular-gate", "step"}, {"specular-vector", "reflection"}};
    expect_agrees(phong);
}

TEST(ZPrepass, SeedFalloffsAndOrthographicCameraAgree) {
    Garden garden;
    for (const Falloff falloff : {Falloff::linear, Falloff::quadratic, Falloff::gltf}) {
        Light light = garden.point(5, falloff == Falloff::gltf ? 5.0f : 1.5f);
        light.falloff = falloff;
        garden.add_light(light, {3.0 * static_cast<int>(falloff) - 3, 2, 2});
    }
    expect_agrees(z_prepass(garden.shot()));
    garden.camera.camera.kind = ProjectionKind::orthographic;
    garden.camera.camera.ymag = 3.5;
    garden.camera.camera.zfar = 30;
    expect_agrees(z_prepass(garden.shot()));
}

// The depth pass obeys the mask, and EQUAL finds each of its surfaces again.
TEST(ZPrepass, MaskedMirroredDoubleSidedUnlit) {
    MixedMaterials mixed;
    expect_agrees(z_prepass(mixed.shot()));
}

// Three walls behind each other fill the picture: one light is evaluated once for each pixel.
TEST(ZPrepass, EachVisiblePixelIsShadedOnce) {
    TestWorld test;
    for (int wall = 0; wall < 3; ++wall) {
        test.add_material({.name = "wall", .base_colour = {0.3f * static_cast<float>(wall), 0.5f, 0.5f, 1}});
        test.add(square(20), glm::translate(glm::dmat4(1), {0, 0, wall - 2.0})); // the nearest comes last
    }
    test.add_light({.kind = LightKind::directional, .intensity = 1}, {0, 0, 0}, {0, 0, -1});
    const Shot shot = z_prepass({.world = &test.world, .camera = front_camera(5)});
    const Stats stats = render_counting_pairs(shot).stats;
    EXPECT_EQ(stats.pairs_evaluated, uint64_t(shot.width) * shot.height);
    EXPECT_EQ(stats.pairs_contributing, uint64_t(shot.width) * shot.height);
    EXPECT_EQ(stats.draws, 6u); // depth and shading of each
    expect_agrees(shot);
}

// 8 lights are one draw, 9 two, 19 three; a light that reaches nothing adds none.
TEST(ZPrepass, ObjectIsDrawnAgainForEachEightLights) {
    TestWorld test;
    test.add_material({.name = "wall", .base_colour = {0.8f, 0.7f, 0.6f, 1}, .metallic = 0, .roughness = 0.6f});
    test.add(square(2));
    const Shot shot = z_prepass({.world = &test.world, .camera = front_camera(5)});
    const auto add_until = [&](size_t count) {
        for (size_t i = test.world.lights.size(); i < count; ++i)
            test.add_light({.kind = LightKind::point, .intensity = 0.3f, .range = 3},
                           {0.15 * double(i) - 1.4, 0.3 * double(i % 7) - 1, 1});
    };
    const std::pair<size_t, uint64_t> expected[] = {{0, 2}, {8, 2}, {9, 3}, {16, 3}, {19, 4}};
    for (const auto& [lights, draws] : expected) {
        add_until(lights);
        EXPECT_EQ(render_counting_pairs(shot).stats.draws, draws) << lights;
    }
    expect_agrees(shot);
    test.add_light({.kind = LightKind::point, .intensity = 9, .range = 1}, {0, 0, 1.5});
    EXPECT_EQ(render_counting_pairs(shot).stats.draws, 4u);
}

// Strongest first, at the point of the object's box that is nearest to the light.
TEST(ZPrepass, ListsGoByStrength) {
    const auto light = [](float intensity, double z, float range = 10) {
        return PlacedLight{{.kind = LightKind::point, .intensity = intensity, .range = range}, {0, 0, z}};
    };
    const std::vector<PlacedLight> lights{light(1, 2),
                                          light(8, 2),
                                          light(4, 1.5),
                                          light(100, 30),
                                          light(2, 2),
                                          light(1, 2),
                                          {{.kind = LightKind::directional, .intensity = 3}, {0, 0, 0}}};
    resident::Draw draw;
    draw.low = {-1, -1, -1};
    draw.high = {1, 1, 1};
    const std::vector<uint32_t> visible{6, 5, 4, 3, 2, 1, 0};
    using resident::ObjectLights;
    const auto list = [&](ObjectLights order) {
        return resident::find_reach(std::span(&draw, 1), lights, visible, order).lights;
    };
    EXPECT_THAT(list(ObjectLights::strongest_first), testing::ElementsAre(2, 1, 6, 4, 0, 5));
    EXPECT_THAT(list(ObjectLights::world_order), testing::ElementsAre(0, 1, 2, 4, 5, 6));
    EXPECT_THAT(list(ObjectLights::none), testing::IsEmpty());
}

TEST(ZPrepass, ManyLightsOfTheBaselineSceneAgree) {
    const Scene scene = make_scene("lights", 256, 1);
    const World world = resolve(scene);
    Shot shot = z_prepass({.world = &world, .camera = world.cameras.at(0)});
    shot.width = 960;
    shot.height = 540;
    expect_agrees(shot);
}

TEST(ForwardOnSwiftShader, AgreeWithTheReference) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    Garden garden;
    garden.add_lights(11, 6, 4);
    garden.add_light(garden.spot(0.6f, 8, 30), {1, 4, 2}, {0, -1, -0.2});
    // At half this size SwiftShader's vertices, snapped to 1/16 pixel, show in the highlights.
    const auto check = [&](const Shot& shot) {
        const Comparison c = against_reference(*device, shot);
        EXPECT_GE(c.psnr, half_float_bound.psnr);
        EXPECT_LE(c.off_share, half_float_bound.off_share);
        EXPECT_LE(c.block, half_float_bound.block);
        expect_validation_clean(*device);
        std::printf("    %.1f dB, %.3f %% off, block %.2f/255\n", c.psnr, c.off_share * 100, c.block);
    };
    Shot multipass = garden.shot();
    multipass.renderer = "multipass";
    multipass.settings = {{"lights-per-pass", "3"}, {"ambient", "per-object"}};
    check(multipass);
    check(z_prepass(garden.shot()));
    MixedMaterials mixed;
    check(z_prepass(mixed.shot()));
}

} // namespace
} // namespace prelight
