// Deferred shading against the reference and the other architectures.
#include "filled_gbuffer.hpp"
#include "garden.hpp"
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;

std::vector<std::string> culling_methods() {
    for (const RendererInfo& info : renderer_infos())
        for (const SettingInfo& setting : info.settings)
            if (info.name == "deferred" && setting.key == "light-culling")
                return setting.values;
    return {};
}

class DeferredForms : public testing::TestWithParam<Form> {};

TEST_P(DeferredForms, AgreeWithTheReference) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    garden.add_light({.kind = LightKind::directional, .intensity = 0.6f}, {0, 0, 0}, {-0.3, -1, -0.5});
    garden.add_light(garden.spot(0.5f, 8, 20), {2, 5, 3}, {-0.3, -1, -0.5});
    Shot shot = deferred(garden.shot(), GetParam().settings);
    shot.shading = GetParam().shading;
    if (shot.shading == Shading::phong)
        shot.exposure = -2;
    expect_agrees(shot);
}

TEST_P(DeferredForms, AgreeWithTheReferenceBacklit) {
    BacklitGarden garden;
    Shot shot = deferred(garden.shot(), GetParam().settings);
    shot.shading = GetParam().shading;
    shot.exposure = shot.shading == Shading::phong ? -3 : -1;
    expect_agrees(shot);
}
INSTANTIATE_TEST_SUITE_P(All, DeferredForms,
                         testing::Values(Form{"full", Shading::ggx, {}}, Form{"nv", Shading::ggx, {{"model", "nv"}}},
                                         Form{"matrix", Shading::ggx, {{"position", "matrix"}}},
                                         Form{"phong", Shading::phong, {}},
                                         Form{"phong_step_gate", Shading::phong, {{"specular-gate", "step"}}},
                                         Form{"phong_reflection", Shading::phong, {{"specular-vector", "reflection"}}}),
                         [](const auto& form) { return std::string(form.param.name); });

TEST(Deferred, MaskedMirroredDoubleSidedUnlit) {
    MixedMaterials mixed;
    expect_agrees(deferred(mixed.shot()));
}

TEST(Deferred, SeedFalloffsAndOrthographicCameraAgree) {
    Garden garden;
    for (const Falloff falloff : {Falloff::linear, Falloff::quadratic, Falloff::gltf}) {
        Light light = garden.point(5, falloff == Falloff::gltf ? 5.0f : 1.5f);
        light.falloff = falloff;
        garden.add_light(light, {3.0 * static_cast<int>(falloff) - 3, 2, 2});
    }
    expect_agrees(deferred(garden.shot()));
    garden.camera.camera.kind = ProjectionKind::orthographic;
    garden.camera.camera.ymag = 3.5;
    garden.camera.camera.zfar = 30;
    expect_agrees(deferred(garden.shot()));
}

TEST(Deferred, TenKilometresFromTheOrigin) {
    Garden garden(glm::dvec3(10000.03, -3.7, -10000.77));
    garden.add_lights(12, 4, 6);
    expect_agrees(deferred(garden.shot()));
}

TEST(Deferred, ManyLightsOfTheBaselineSceneAgree) {
    const Scene scene = make_scene("lights", 256, 1);
    const World world = resolve(scene);
    Shot shot = deferred({.world = &world, .camera = world.cameras.at(0)});
    shot.width = 960;
    shot.height = 540;
    expect_agrees(shot);
}

// Each object is drawn once, and light is what RT0 holds in the end: no pass over geometry after it.
TEST(Deferred, GeometryIsDrawnOnce) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    const auto renderer =
        create_renderer("deferred", &test_device(),
                        {.width = 64, .height = 36, .settings = {{"light-culling", "volumes"}}, .views = {}});
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_EQ(renderer->stats().draws, garden.world.instances.size());
    std::vector<std::string> names;
    for (const PassStats& pass : renderer->stats().passes)
        names.push_back(pass.name);
    EXPECT_THAT(names, testing::ElementsAre("geometry", "light", "resolve"));
}

// Two architectures, one form: what differs is rounding.
TEST(Deferred, AgreesWithLightPrepassAndZPrepass) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    const auto expect_same = [&](const char* other, const Settings& settings) {
        Shot shot = garden.shot();
        shot.renderer = other;
        shot.settings = settings;
        const Comparison c = compare_pixels(picture_of(deferred(garden.shot(), settings)), picture_of(shot));
        EXPECT_GE(c.psnr, half_float_bound.psnr) << other;
        EXPECT_LE(c.off_share, half_float_bound.off_share) << other;
        EXPECT_LE(c.block, half_float_bound.block) << other;
        std::printf("    %s: %.1f dB, block %.2f/255\n", other, c.psnr, c.block);
    };
    expect_same("light-prepass", {{"model", "nv"}});
    expect_same("z-prepass", {{"model", "full"}});
    expect_same("z-prepass", {{"model", "nv"}});
}

TEST(Deferred, OrderOfLightsOnlyRounds) {
    Garden garden, reversed;
    garden.add_lights(24, 4, 3);
    reversed.world.lights.assign(garden.world.lights.rbegin(), garden.world.lights.rend());
    for (const Settings& settings : {Settings{}, {{"g-buffer", "killzone2"}}}) {
        const Image picture = picture_of(deferred(garden.shot(), settings));
        const Comparison c = compare_pixels(picture, picture_of(deferred(reversed.shot(), settings)));
        EXPECT_GE(c.psnr, 65);
        EXPECT_LE(c.block, 0.5);
        const Image again = picture_of(deferred(garden.shot(), settings));
        EXPECT_EQ(picture.pixels, again.pixels) << "two runs give the same bytes";
    }
}

TEST(Deferred, NeverHoldsInfinity) {
    Garden garden;
    garden.add_light(garden.point(50, 1e6f), {0, 2.05, 0.8});
    for (int i = 0; i < 40; ++i)
        garden.add_light(garden.point(50, 1e5f), {0.01 * i, 3, 0});
    for (const char* accumulation : {"rgba16f", "rgba8"}) {
        Shot shot = deferred(garden.shot(), {{"accumulation", accumulation}});
        shot.exposure = 12;
        for (const glm::vec3& value : picture_of(shot).pixels)
            for (int c = 0; c < 3; ++c) {
                ASSERT_TRUE(std::isfinite(value[c]));
                ASSERT_LE(value[c], 65504.0f);
            }
    }
    expect_validation_clean(test_device());
}

// Camera outside, on the edge of, and inside the volume, the near plane cutting it: every way to
// find pixels lights the same ones.
TEST(Deferred, EveryCullingMethodLightsTheSamePixels) {
    for (const double share : {2.5, 0.95, 0.05}) {
        Garden garden;
        garden.camera.camera.znear = 0.25; // a large near rectangle, so that volumes are really cut
        for (const Light& light : {garden.point(4, 12), garden.spot(0.4f, 6, 60)})
            garden.add_light(light, garden.camera.position - garden.camera.axes[2] * (share * light.range),
                             {0, -1, -0.3});
        Image baseline;
        uint64_t contributing = 0;
        const auto expect_same = [&](const std::string& method) {
            RenderOptions options = options_of(deferred(garden.shot(), {{"light-culling", method}}));
            options.width = 160;
            options.height = 90;
            options.count_pairs = true;
            const auto renderer = create_renderer("deferred", &test_device(), options);
            renderer->set_world(garden.world);
            renderer->render(garden.camera);
            const Image picture = renderer->read("linear");
            if (baseline.pixels.empty()) {
                baseline = picture;
                contributing = renderer->stats().pairs_contributing;
            }
            EXPECT_EQ(renderer->stats().pairs_contributing, contributing) << method << " at " << share;
            EXPECT_GE(compare_pixels(picture, baseline).psnr, 70) << method << " at " << share;
        };
        expect_same("fullscreen");
        for (const std::string& method : culling_methods())
            if (method != "fullscreen")
                expect_same(method);
    }
    expect_validation_clean(test_device());
}

TEST(Deferred, EveryCullingMethodAgreesWithTheReference) {
    for (const std::string& method : culling_methods()) {
        Garden garden;
        garden.add_lights(10, 4, 6);
        garden.add_light(garden.spot(0.5f, 18, 40), garden.at(0.5, 3.8, 6.5), {0, -0.5, -1});
        garden.add_light({.kind = LightKind::directional, .intensity = 0.4f}, {0, 0, 0}, {-0.3, -1, -0.5});
        std::printf("    %s\n", method.c_str());
        expect_agrees(deferred(garden.shot(), {{"light-culling", method}}));
    }
}

} // namespace
} // namespace prelight
