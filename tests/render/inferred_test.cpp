// Inferred lighting: at the picture's own size it is the light pre-pass, and below it what the reference finds by the
// same rules, written once more.
#include "decal_world.hpp"
#include "panes.hpp"
#include <algorithm>
#include <prelight/error.hpp>

namespace prelight {
namespace {

using InferredWay = std::map<std::string, std::string>;

Shot inferred(Shot shot, const InferredWay& settings) {
    shot.renderer = "inferred";
    return with(std::move(shot), settings);
}

PlacedCamera seen_in_parallel(const Garden& garden) {
    return look_at({.kind = ProjectionKind::orthographic, .ymag = 3.2, .znear = 0, .zfar = 40}, garden.at(1, 4, 7),
                   garden.at(0, 0.5, 0));
}

/// The garden with lights of every kind.
struct LampGarden : Garden {
    LampGarden() {
        add_lights(24, 4, 3);
        add_light(spot(0.7f, 9, 30), at(1, 4, 3), {0, -1, -0.2});
        add_light({.kind = LightKind::directional, .colour = {0.9f, 0.8f, 1}, .intensity = 0.6f}, {}, {0.2, -1, -0.7});
        world.ambient = glm::vec3(0.05f);
    }
};

/// The stats of one picture.
Stats inferred_stats(const Shot& shot, const std::vector<std::string>& views = {"linear"}, Image* view = nullptr) {
    RenderOptions options = options_of(shot);
    options.views = views;
    const auto renderer = create_renderer("inferred", &test_device(), options);
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    if (view)
        *view = renderer->read(views[0]);
    return renderer->stats();
}

TEST(Inferred, IsTheLightPrePassAtFullSizeBitForBit) {
    DecalGarden garden;
    garden.add_lights(24, 4, 3);
    garden.add_light(garden.spot(0.7f, 9, 30), {1, 4, 3}, {0, -1, -0.2});
    garden.world.ambient = glm::vec3(0.05f);
    std::vector<InferredWay> ways{
        {{"shadows", "on"}}, {{"ssao", "full"}}, {{"model", "nv"}}, {{"light-buffer", "packed-rgba16f"}}};
    for (const char* culling : {"volumes", "fullscreen", "rectangles", "stencil", "tiles", "clusters"})
        ways.push_back({{"light-culling", culling}});
    bool perspective = false;
    for (const InferredWay& way : ways) {
        SCOPED_TRACE(way.begin()->first + "=" + way.begin()->second);
        Shot shot = with(garden.shot(), way);
        perspective = !perspective;
        if (!perspective)
            shot.camera = seen_in_parallel(garden);
        shot.width = 161, shot.height = 91;
        const Image expected = render_linear(test_device(), shot);
        EXPECT_EQ(render_linear(test_device(), inferred(shot, {{"inferred-scale", "1"}})).pixels, expected.pixels);
    }
    expect_validation_clean(test_device());
}

TEST(Inferred, EachScaleAgreesWithTheReference) {
    LampGarden garden;
    for (const char* scale : {"3/4", "5/8", "1/2"})
        for (const bool perspective : {true, false}) {
            SCOPED_TRACE(std::string(scale) + (perspective ? "" : ", orthographic"));
            Shot shot = inferred(garden.shot(), {{"inferred-scale", scale}});
            shot.width = 321, shot.height = 181; // no multiples
            if (!perspective)
                shot.camera = seen_in_parallel(garden);
            expect_agrees(shot, {.left_out = 0.15});
        }
}

TEST(Inferred, EachCullingAndBufferAgreesWithTheReference) {
    LampGarden garden;
    std::vector<InferredWay> ways{{{"model", "nv"}}, {{"light-buffer", "packed-rgba16f"}}};
    for (const char* culling : {"volumes", "fullscreen", "rectangles", "stencil", "clusters"})
        ways.push_back({{"light-culling", culling}});
    for (const InferredWay& way : ways) {
        SCOPED_TRACE(way.begin()->second);
        Shot shot = inferred(garden.shot(), way);
        shot.width = 200, shot.height = 112;
        expect_agrees(shot, {.left_out = 0.2});
    }
}

/// A pane, a ball and a bottle's worth of layers before and among the garden's spheres, all lit.
struct ThreeLayers : LampGarden {
    explicit ThreeLayers(int panes = 2) {
        for (int i = 0; i < panes; ++i) {
            Material material{.name = "pane", .metallic = 0.1f, .roughness = 0.5f};
            material.base_colour = {0.4f + 0.1f * float(i), 0.8f - 0.1f * float(i), 0.9f, 0.4f};
            material.alpha_mode = AlphaMode::blend;
            add_material(material);
            add(square(0.9f), glm::rotate(placed_at(-1 + 0.7 * i, 1, 2 + 0.4 * i), -0.2, {1, 0, 0}));
        }
        Material ball{.name = "ball", .metallic = 0, .roughness = 0.6f};
        ball.base_colour = {0.9f, 0.5f, 0.4f, 0.5f};
        ball.alpha_mode = AlphaMode::blend;
        add_material(ball);
        add(sphere(), glm::scale(placed_at(2.4, 0.8, 2), glm::dvec3(0.6)));
    }
};

TEST(Inferred, LayersAgreeWithTheReference) {
    const ThreeLayers layers;
    for (const char* scale : {"1", "5/8", "1/2"})
        for (const bool perspective : {true, false}) {
            SCOPED_TRACE(std::string(scale) + (perspective ? "" : ", orthographic"));
            Shot shot = inferred(layers.shot(), {{"inferred-scale", scale}});
            if (!perspective)
                shot.camera = seen_in_parallel(layers);
            expect_agrees(shot, {.left_out = 0.2});
        }
    const InferredStats stats = inferred_stats(inferred(layers.shot(), {})).inferred.value();
    EXPECT_EQ(stats.layers, 3u);
    EXPECT_EQ(stats.layers_without_slot, 0u);
}

// The light of a layer is its own, and not that of what is behind it.
TEST(Inferred, ALightBeforeAllOpaqueSurfacesLightsThePane) {
    Panes panes(1, true);
    panes.world.ambient = glm::vec3(0);
    Shot shot = inferred(panes.shot(), {{"inferred-scale", "1/2"}});
    shot.width = 256, shot.height = 144; // so that the light is many texels wide
    const glm::vec3 dark = middle_of(render_linear(test_device(), shot));
    panes.add_light({.kind = LightKind::point, .intensity = 1, .range = 1}, {0, 0, -0.5});
    const glm::vec3 lit = middle_of(render_linear(test_device(), shot));
    const glm::dvec4 pane = panes.layers[0];
    for (int c = 0; c < 3; ++c) { // as of the forward ways: transparency_test.cpp
        const double should = pane.a * pane[c] * (1 - 1 / 16.0) * 4 / 3.14159;
        EXPECT_GT(lit[c] - dark[c], 0.85 * should) << c;
        EXPECT_LT(lit[c] - dark[c], should) << c;
    }
}

TEST(Inferred, MoreThanThreeLayersAreCountedAndTheNearestIsLit) {
    Panes panes(4, true);
    panes.world.ambient = glm::vec3(0);
    panes.add_light({.kind = LightKind::directional, .intensity = 2}, {}, {0, 0, -1});
    const Shot shot = inferred(panes.shot(), {{"inferred-scale", "1/2"}});
    const Stats stats = inferred_stats(shot);
    EXPECT_EQ(stats.inferred.value().layers, 4u);
    EXPECT_EQ(stats.inferred->layers_without_slot, 1u);
    EXPECT_THAT(stats.notes, testing::Contains(testing::HasSubstr("1 of 4 blended draws share their slot")));
    expect_agrees(shot, {.left_out = 0.2});
    const Panes three(3, true);
    EXPECT_EQ(inferred_stats(inferred(three.shot(), {})).inferred->layers_without_slot, 0u);
}

// Wires thinner than a texel of the light: some pixels find none that shows theirs.
TEST(Inferred, PixelsWithoutATexelOfTheirSurfaceAreCountedAndShown) {
    LampGarden garden;
    Shot shot = inferred(garden.shot(), {{"inferred-scale", "1/2"}});
    for (int i = 0; i < 12; ++i)
        garden.add(square(1), glm::scale(placed_at(-2 + 0.35 * i, 1.2, 2), {0.008, 1, 1}));
    Image view;
    const Stats stats = inferred_stats(shot, {"dsf-fallback"}, &view);
    const auto white = std::count_if(view.pixels.begin(), view.pixels.end(),
                                     [](const glm::vec3& pixel) { return pixel.r > 0.99f && pixel.g > 0.99f; });
    EXPECT_EQ(stats.inferred.value().unmatched_pixels, static_cast<uint64_t>(white));
    EXPECT_GT(white, 100);
    expect_agrees(shot, {.left_out = 0.3});
    EXPECT_EQ(inferred_stats(with(shot, {}), {"linear"}).inferred->layers, 0u);
    shot.settings["inferred-scale"] = "1";
    EXPECT_EQ(inferred_stats(shot).inferred->unmatched_pixels, 0u);
}

TEST(Inferred, ShadowsOcclusionAndDecalsAgreeWithTheReference) {
    DecalGarden decals;
    decals.add_lights(12, 5, 4);
    Shot shot = inferred(decals.shot(), {{"inferred-scale", "1/2"}});
    expect_agrees(shot, {.left_out = 0.25});
    LampGarden garden;
    shot = inferred(garden.shot(), {{"inferred-scale", "5/8"}, {"shadows", "on"}});
    expect_agrees(shot, {.left_out = 0.5});
}

TEST(Inferred, OpaqueLayersAreTheLightPrePassOfOpaqueOnes) {
    const ThreeLayers layers;
    const Shot shot = inferred(layers.shot(), {{"inferred-scale", "1"}, {"inferred-layers", "off"}});
    Shot other = layers.shot();
    other.settings["transparency"] = "opaque";
    EXPECT_EQ(render_linear(test_device(), shot).pixels, render_linear(test_device(), other).pixels);
}

TEST(Inferred, AKeptRendererGivesThePictureOfANewOne) {
    ThreeLayers layers;
    const Shot shot =
        inferred(layers.shot(), {{"inferred-scale", "1/2"}, {"shadows", "on"}, {"shadow-budget", "1048576"}});
    const RenderOptions options = options_of(shot);
    const auto kept = create_renderer("inferred", &test_device(), options);
    kept->set_world(layers.world);
    kept->render(layers.camera, 3);
    WorldChanges changes;
    layers.world.instances.back().transform = placed_at(-1.4, 0.9, 2.5);
    changes.instances = {static_cast<uint32_t>(layers.world.instances.size() - 1)};
    kept->update_world(changes);
    layers.add_lights(80, 4, 1); // more than there was room for
    kept->set_lights(layers.world.lights);
    kept->resize(150, 85);
    kept->render(layers.camera, 2);
    Shot smaller = shot;
    smaller.width = 150, smaller.height = 85;
    EXPECT_EQ(kept->read("linear").pixels, render_linear(test_device(), smaller).pixels);
    expect_validation_clean(test_device());
}

TEST(Inferred, RefusesWhatItHasNot) {
    const auto refusal = [](const RenderOptions& options) {
        try {
            create_renderer("inferred", &test_device(), options);
        } catch (const UsageError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_THAT(refusal({.msaa = 4}), testing::HasSubstr("one sample a pixel"));
    EXPECT_THAT(refusal({.settings = {{"light-buffer", "rgba8"}}}), testing::HasSubstr("packed-rgba16f"));
    EXPECT_THAT(refusal({.settings = {{"inferred-scale", "1/3"}}}), testing::HasSubstr("5/8"));
}

TEST(Inferred, SwiftShaderAgreesWithTheReference) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed";
    const ThreeLayers layers;
    Shot shot = inferred(layers.shot(), {{"inferred-scale", "1/2"}});
    shot.width = 160, shot.height = 90;
    // It snaps vertices to a sixteenth of a pixel: some texels at edges show what the reference sees beside them.
    expect_within(against_reference(*device, shot), {.off_share = 0.005, .left_out = 0.2});
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
