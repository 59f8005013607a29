// Multi-pass forward against the reference.
#include "garden.hpp"
#include <cmath>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;

Shot multipass(Shot shot, Settings settings = {}) {
    shot.renderer = "multipass";
    shot.settings = std::move(settings);
    return shot;
}

Stats stats_of(const Shot& shot) {
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    return renderer->stats();
}

class MultipassForms : public testing::TestWithParam<Form> {};

// with every kind of light.
TEST_P(MultipassForms, AgreeWithTheReference) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    garden.add_light({.kind = LightKind::directional, .intensity = 0.6f}, {0, 0, 0}, {-0.3, -1, -0.5});
    garden.add_light(garden.spot(0.5f, 8, 20), {2, 5, 3}, {-0.3, -1, -0.5});
    garden.add_light(garden.point(std::numeric_limits<float>::infinity(), 4), {0, 4, 3});
    Shot shot = multipass(garden.shot(), GetParam().settings);
    shot.shading = GetParam().shading;
    if (shot.shading == Shading::phong)
        shot.exposure = -2;
    expect_agrees(shot);
}

// Low lights behind what is seen: V·H and N·V are far apart.
TEST_P(MultipassForms, BacklitAgreeWithTheReference) {
    BacklitGarden garden;
    garden.world.lights[0].light.colour = {1, 0.2f, 0.1f};
    garden.world.lights[2].light.colour = {0.1f, 0.3f, 1};
    Shot shot = multipass(garden.shot(), GetParam().settings);
    shot.shading = GetParam().shading;
    shot.exposure = -1;
    expect_agrees(shot);
}
INSTANTIATE_TEST_SUITE_P(Multipass, MultipassForms,
                         testing::Values(Form{"full", Shading::ggx, {}}, Form{"nv", Shading::ggx, {{"model", "nv"}}},
                                         Form{"phong", Shading::phong, {}},
                                         Form{"phong_step_gate", Shading::phong, {{"specular-gate", "step"}}},
                                         Form{"phong_reflection", Shading::phong, {{"specular-vector", "reflection"}}}),
                         [](const auto& form) { return std::string(form.param.name); });

// An alpha mask's holes have another's depth: LESS_OR_EQUAL must not light what is not there, EQUAL cannot.
TEST(Multipass, LessOrEqualAndEqualGiveTheSamePicture) {
    MixedMaterials mixed;
    const Settings forms[] = {
        {{"ambient", "first"}}, {{"ambient", "per-object"}}, {{"ambient", "per-object"}, {"order", "objects"}}};
    for (Settings settings : forms) {
        const Shot by_default = multipass(mixed.shot(), settings);
        settings["depth-test"] = "less-equal";
        const Shot less = multipass(mixed.shot(), settings);
        settings["depth-test"] = "equal";
        const Shot equal = multipass(mixed.shot(), settings);
        expect_agrees(less);
        expect_agrees(equal);
        const Image image = render_linear(test_device(), less);
        EXPECT_TRUE(image.pixels == render_linear(test_device(), equal).pixels);
        EXPECT_TRUE(image.pixels == render_linear(test_device(), by_default).pixels);
        EXPECT_EQ(stats_of(by_default).settings.at("depth-test"), "less-equal");
    }
}

// 14 lights are no multiple of 3 or 8; most objects are reached by more than eight.
TEST(Multipass, EveryOrderAmbientAndBatchGivesTheSamePicture) {
    Garden garden;
    garden.add_lights(14, 7, 5);
    const Image first = render_linear(test_device(), multipass(garden.shot()));
    uint64_t fewest = 0;
    for (const char* per_pass : {"1", "3", "8"})
        for (const char* order : {"lights", "objects"})
            for (const char* ambient : {"first", "per-object"}) {
                SCOPED_TRACE(std::string(per_pass) + " " + order + " " + ambient);
                const Shot shot =
                    multipass(garden.shot(), {{"lights-per-pass", per_pass}, {"order", order}, {"ambient", ambient}});
                expect_agrees(shot);
                EXPECT_GE(compare_pixels(render_linear(test_device(), shot), first).psnr, 60);
                const uint64_t draws = stats_of(shot).draws;
                EXPECT_TRUE(fewest == 0 || per_pass[0] == '1' || draws < fewest) << draws;
                fewest = fewest == 0 ? draws : fewest;
            }
}

TEST(Multipass, MaskedMirroredDoubleSidedUnlit) {
    MixedMaterials mixed;
    for (const char* order : {"lights", "objects"})
        for (const char* ambient : {"first", "per-object"})
            expect_agrees(multipass(mixed.shot(), {{"order", order}, {"ambient", ambient}, {"lights-per-pass", "4"}}));
}

// A light costs one draw for each object that it reaches, and none where it reaches nothing.
TEST(Multipass, ALightThatReachesNothingCostsNoDraw) {
    TestWorld test;
    test.add_material();
    for (int i = 0; i < 4; ++i)
        test.add(square(0.4f), glm::translate(glm::dmat4(1), {1.2 * i - 1.8, 0, 0}));
    const Shot shot{.world = &test.world, .camera = front_camera(5)};
    const Light small{.kind = LightKind::point, .intensity = 1, .range = 0.7f};
    for (const char* order : {"lights", "objects"}) {
        test.world.lights.clear();
        const Shot one = multipass(shot, {{"order", order}});
        EXPECT_EQ(stats_of(one).draws, 4u);
        test.add_light(small, {-1.8, 0, 0.5}); // the first square alone
        EXPECT_EQ(stats_of(one).draws, 5u);
        test.add_light(small, {0, 0, 0.5}); // between the second and the third
        EXPECT_EQ(stats_of(one).draws, 7u);
        test.add_light(small, {0, 0, 1});   // before all of them
        test.add_light(small, {0, 1.2, 0}); // above them
        test.add_light({.kind = LightKind::spot, .intensity = 1, .range = 9, .outer_cone = 0.3f}, {0, 0, 2}, {0, 0, 1});
        EXPECT_EQ(stats_of(one).draws, 7u);
        test.add_light({.kind = LightKind::directional, .intensity = 1}, {0, 0, 0}, {0, 0, -1});
        EXPECT_EQ(stats_of(one).draws, 11u);
        test.add_light({.kind = LightKind::spot, .intensity = 1, .range = 9, .outer_cone = 0.2f}, {1.8, 0, 2},
                       {0, 0, -1});
        EXPECT_EQ(stats_of(one).draws, 12u);
        expect_agrees(one);
    }
}

TEST(Multipass, ManyLightsOfTheBaselineSceneAgree) {
    const Scene scene = make_scene("lights", 256, 1);
    const World world = resolve(scene);
    Shot shot =
        multipass({.world = &world, .camera = world.cameras.at(0)}, {{"lights-per-pass", "8"}, {"order", "objects"}});
    shot.width = 960;
    shot.height = 540;
    expect_agrees(shot);
}

// Two surfaces in exactly the same place: the one drawn last replaces the other, lights and all. With
// ambient=first both are lit, as docs/multipass.md says.
TEST(Multipass, CoincidentSurfacesAreLitOnceWithAmbientPerObject) {
    TestWorld one, two;
    for (TestWorld* test : {&one, &two}) {
        test->add_material({.name = "wall", .base_colour = {0.8f, 0.7f, 0.6f, 1}, .metallic = 0, .roughness = 0.6f});
        for (int i = 0; i < (test == &one ? 1 : 2); ++i)
            test->add(square(2));
        for (int i = 0; i < 11; ++i)
            test->add_light({.kind = LightKind::point, .intensity = 0.5f, .range = 5}, {0.3 * i - 1.5, 0.2, 1});
    }
    Shot single{.world = &one.world, .camera = front_camera(5)}, twice = single;
    twice.world = &two.world;
    EXPECT_TRUE(
        render_linear(test_device(), multipass(twice, {{"ambient", "per-object"}, {"order", "objects"}})).pixels ==
        render_linear(test_device(), multipass(single, {{"ambient", "per-object"}, {"order", "objects"}})).pixels);
    single.renderer = twice.renderer = "z-prepass";
    EXPECT_TRUE(render_linear(test_device(), twice).pixels == render_linear(test_device(), single).pixels);
}

TEST(Multipass, HalfFloatTargetHoldsNoInfinity) {
    Garden garden;
    for (int i = 0; i < 60; ++i)
        garden.add_light(garden.point(30, 1e6f), {0.1 * i - 3, 3, 2});
    // lavapipe cuts off at the largest half float by itself, SwiftShader goes to infinity.
    Device* const second = swiftshader_device();
    for (Device* device : {&test_device(), second})
        for (const char* per_pass : {"1", "8"}) {
            if (!device)
                continue;
            const Image image = render_linear(*device, multipass(garden.shot(), {{"lights-per-pass", per_pass}}));
            float brightest = 0;
            for (const glm::vec3& p : image.pixels)
                for (int c = 0; c < 3; ++c) {
                    ASSERT_TRUE(std::isfinite(p[c]));
                    brightest = std::max(brightest, p[c]);
                }
            EXPECT_GT(brightest, 20000);
        }
}

TEST(Multipass, PairsAndViews) {
    Garden garden;
    garden.add_lights(10, 4, 6);
    const Stats ones = render_counting_pairs(multipass(garden.shot())).stats;
    const Shot by_eights = multipass(garden.shot(), {{"lights-per-pass", "8"}, {"order", "objects"}});
    const Stats eights = render_counting_pairs(by_eights).stats;
    EXPECT_GT(ones.pairs_contributing, 0u);
    EXPECT_GT(ones.pairs_evaluated, ones.pairs_contributing);
    EXPECT_EQ(ones.pairs_evaluated, eights.pairs_evaluated);
    EXPECT_EQ(ones.pairs_contributing, eights.pairs_contributing);
    for (const RendererInfo& info : renderer_infos()) {
        if (info.name != "multipass" && info.name != "z-prepass")
            continue;
        RenderOptions options{.width = 160, .height = 90};
        options.views = info.views;
        const auto renderer = create_renderer(info.name, &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        for (const std::string& view : info.views) {
            float low = 1e9f, high = -1e9f;
            for (const glm::vec3& p : renderer->read(view).pixels) {
                low = std::min({low, p.x, p.y, p.z});
                high = std::max({high, p.x, p.y, p.z});
            }
            EXPECT_GE(low, 0) << view;
            if (view == "layers") // of opaque surfaces there are none
                EXPECT_EQ(high, 0);
            else
                EXPECT_GT(high - low, 0.1f) << info.name << " " << view << " is black or flat";
        }
    }
    expect_validation_clean(test_device());
}

TEST(Multipass, TwoRunsGiveTheSameBytes) {
    Garden garden;
    garden.add_lights(40, 4, 3);
    const Shot shot = multipass(garden.shot(), {{"lights-per-pass", "3"}});
    EXPECT_TRUE(render_linear(test_device(), shot).pixels == render_linear(test_device(), shot).pixels);
}

} // namespace
} // namespace prelight
