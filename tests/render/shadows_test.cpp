// Shadow maps against the reference's shadow rays, in every architecture.
#include "every_way.hpp"
#include "garden.hpp"
#include "shadow_measure.hpp"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;

/// A garden with one light of each kind, all of which cast shadows.
struct ShadowGarden : Garden {
    ShadowGarden() {
        add_light({.kind = LightKind::directional, .colour = {1, 0.9f, 0.8f}, .intensity = 0.8f}, at(0, 5, 0),
                  glm::normalize(glm::dvec3(-0.5, -1, -0.3)));
        add_light(point(9, 7), at(-1, 2.6, 2.2));
        add_light(spot(0.6f, 12, 40), at(4, 5, 3), glm::normalize(glm::dvec3(-0.7, -1, -0.6)));
        add_light(spot(1.3f, 9, 9), at(-4, 3.2, 1), glm::normalize(glm::dvec3(0.3, -1, -0.3)));
    }
    Shot shot() const {
        Shot shot = Garden::shot();
        shot.settings = {
            {"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}, {"shadow-budget", "16777216"}};
        shot.width = 400, shot.height = 225;
        return shot;
    }
};

TEST(Shadows, EveryArchitectureAgreesWithShadowRays) {
    const ShadowGarden garden;
    Shot form = garden.shot();
    const ReferencePicture reference =
        render_reference(garden.world, garden.camera, form.width, form.height, 0,
                         {.fresnel = ReferenceForm::Fresnel::nv, .shadows = true, .specular_antialiasing = true});
    const auto shadowed = std::ranges::count_if(reference.shadow_mask, [](uint64_t mask) { return mask != 0; });
    EXPECT_GT(size_t(shadowed), reference.shadow_mask.size() / 10) << "the scene has shadows to compare";
    for (const Shot& shot : every_way(form)) {
        SCOPED_TRACE(name_of(shot));
        const Image image = render_linear(test_device(), shot);
        expect_within(compare_pixels(image, reference.linear, reference.left_out()), half_float_bound);
    }
    expect_validation_clean(test_device());
}

TEST(Shadows, EachKindOfLightAgreesWithShadowRays) {
    const ShadowGarden garden;
    for (const PlacedLight& light : garden.world.lights) {
        World world = garden.world;
        world.lights = {light};
        Shot shot = garden.shot();
        shot.world = &world;
        expect_agrees(shot);
    }
}

// A light that casts none is as it was without shadows.
TEST(Shadows, ALightMayCastNone) {
    const ShadowGarden garden;
    World world = garden.world;
    for (PlacedLight& light : world.lights)
        light.light.casts_shadow = &light == &world.lights[0];
    Shot shot = garden.shot();
    shot.world = &world;
    expect_agrees(shot);
}

// Lee's way: each light's maps in the memory that the light before had.
TEST(Shadows, OneLightAfterTheOtherInTheSameMemory) {
    const ShadowGarden garden;
    Shot shot = garden.shot();
    shot.settings["shadow-budget"] = "8388608"; // a half: for one light it is enough
    shot.settings["shadow-memory"] = "reuse";
    References references;
    for (const char* renderer : {"light-prepass", "deferred"})
        for (const char* culling : {"auto", "volumes", "rectangles", "stencil", "fullscreen"}) {
            SCOPED_TRACE(std::string(renderer) + " " + culling);
            shot.renderer = renderer;
            shot.settings["light-culling"] = culling;
            references.expect_agrees(shot);
        }
    const auto one = create_renderer("light-prepass", &test_device(), options_of(shot));
    one->set_world(garden.world);
    one->render(garden.camera, 2);
    const ShadowStats stats = one->stats().shadows.value();
    EXPECT_EQ(stats.lights, 4u);
    EXPECT_EQ(stats.tiles_drawn, 17u) << "the next light drew over them";
    EXPECT_LE(stats.texels, stats.budget);
    for (const char* culling : {"tiles", "clusters"}) {
        shot.settings["light-culling"] = culling;
        EXPECT_THROW(create_renderer("light-prepass", &test_device(), options_of(shot)), UsageError);
        EXPECT_THROW(create_renderer("deferred", &test_device(), options_of(shot)), UsageError);
    }
}

// `pcf` makes no comparisons where the extremes around a point know what they would say. Maps that are drawn light by
// light have none, and all comparisons are made.
TEST(Shadows, ExtremesSayWhatComparisonsWould) {
    const ShadowGarden garden;
    for (const PlacedLight& light : garden.world.lights)
        for (const char* budget : {"4194304", "16"}) { // the second leaves tiles that are smaller than a cell
            World world = garden.world;
            world.lights = {light};
            Shot shot = garden.shot();
            shot.world = &world, shot.width = 256, shot.height = 144;
            shot.settings["shadow-filter"] = "pcf";
            shot.settings["shadow-detail"] = "1";
            shot.settings["shadow-budget"] = budget;
            shot.settings["light-culling"] = "volumes";
            const Image asked = render_linear(test_device(), shot);
            shot.settings["shadow-memory"] = "reuse";
            EXPECT_EQ(asked.pixels, render_linear(test_device(), shot).pixels)
                << "kind " << int(light.light.kind) << ", budget " << budget;
        }
}

// Nobody makes extremes that no one asks for.
TEST(Shadows, OnlyPcfHasExtremes) {
    const ShadowGarden garden;
    for (const auto& [filter, memory] :
         {std::pair("pcf", "atlas"), {"hard", "atlas"}, {"contact", "atlas"}, {"pcf", "reuse"}}) {
        Shot shot = garden.shot();
        shot.width = 96, shot.height = 54;
        shot.settings = {
            {"shadows", "on"}, {"shadow-budget", "65536"}, {"shadow-filter", filter}, {"shadow-memory", memory}};
        const auto renderer = create_renderer("light-prepass", &test_device(), options_of(shot));
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        const Stats stats = renderer->stats();
        const bool made = std::any_of(stats.passes.begin(), stats.passes.end(),
                                      [](const auto& pass) { return pass.name == "shadow extremes"; });
        EXPECT_EQ(made, std::string_view(filter) == "pcf" && std::string_view(memory) == "atlas") << filter << memory;
    }
}

World with_sun(const Scene& scene, glm::dvec3 direction) {
    World world = resolve(scene);
    world.lights = {{{.kind = LightKind::directional, .intensity = 3}, glm::dvec3(0), glm::normalize(direction)}};
    return world;
}

ShadowStats shadows_of(Renderer& renderer, const PlacedCamera& camera) {
    renderer.render(camera);
    return renderer.stats().shadows.value();
}

class ShadowFilters : public testing::TestWithParam<const char*> {};

TEST_P(ShadowFilters, NoAcneAndNoGapInTheSceneOfShadows) {
    const Scene scene = make_scene("shadows", 4, 1);
    const World all = resolve(scene);
    const auto check = [&](const World& world, const PlacedCamera& camera) {
        SCOPED_TRACE(std::to_string(world.lights.size()) + " lights, " + world.lights[0].light.name + ", camera " +
                     camera.camera.name);
        expect_shadows_right({.world = &world,
                              .camera = camera,
                              .width = 256,
                              .height = 144,
                              .settings = {{"shadows", "on"}, {"shadow-filter", GetParam()}}},
                             5);
    };
    for (const PlacedLight& light : all.lights) {
        World world = all;
        world.lights = {light};
        check(world, all.cameras.at(2));
    }
    check(all, all.cameras.at(0)); // near and far
    check(all, all.cameras.at(1));
}

TEST_P(ShadowFilters, NoAcneAndNoGapInSponza) {
    const std::filesystem::path file = std::filesystem::path(PRELIGHT_SHARED_SCENES) / "sponza-512.glb";
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "no shared scenes beside the repository";
    const Scene scene = load_gltf(file);
    const World world = with_sun(scene, {0.2, -1, 0.15});
    Camera lens;
    lens.yfov = 0.9;
    expect_shadows_right({.world = &world,
                          .camera = look_at(lens, {-2, 2, 0}, {0, 0, -0.3}),
                          .settings = {{"shadows", "on"}, {"shadow-filter", GetParam()}}},
                         6);
}

TEST(Shadows, SponzaUnderASunAndSixtyFourSpots) {
    const std::filesystem::path file = std::filesystem::path(PRELIGHT_SHARED_SCENES) / "sponza-512.glb";
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "no shared scenes beside the repository";
    const Scene scene = load_gltf(file);
    World world = with_sun(scene, {0.2, -1, 0.15});
    for (int i = 0; i < 64; ++i) {
        const float hue = 0.7f * static_cast<float>(i);
        const Light spot{.kind = LightKind::spot,
                         .colour = {0.6f + 0.4f * std::cos(hue), 0.7f, 0.6f - 0.4f * std::cos(hue)},
                         .intensity = 12,
                         .range = 8,
                         .inner_cone = 0.3f,
                         .outer_cone = 0.55f};
        world.lights.push_back({spot, glm::dvec3(-10.5 + 1.4 * (i % 16), 4 + 0.3 * (i % 3), -4.5 + 3.0 * (i / 16)),
                                glm::normalize(glm::dvec3(0.3 * std::cos(2.4 * i), -1, 0.3 * std::sin(2.4 * i)))});
    }
    Camera lens;
    lens.yfov = 0.9;
    const Shot shot{.world = &world,
                    .camera = look_at(lens, {-2, 2, 0}, {0, 0, -0.3}),
                    .exposure = -1,
                    .settings = {{"shadows", "on"}}};
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(world);
    const ShadowStats stats = shadows_of(*renderer, shot.camera);
    EXPECT_GE(stats.lights, 30u);
    EXPECT_EQ(stats.lights_without, 0u);
    expect_shadows_right(shot, 8);
}
INSTANTIATE_TEST_SUITE_P(All, ShadowFilters, testing::Values("pcf", "contact"));

TEST(Shadows, NoAcneAndNoGapInTheCity) {
    const Scene scene = make_scene("city", 64, 1);
    const World lamps = resolve(scene);
    World world = lamps; // a sun would not come through the sky, which is an object
    const glm::dvec3 from(-4.2, 4.5, 4.6), bin(-5.75, 0.14, 3);
    world.lights = {{{.kind = LightKind::spot, .intensity = 90, .range = 14, .inner_cone = 0.5f, .outer_cone = 0.8f},
                     from,
                     glm::normalize(bin - from)}};
    Camera lens;
    lens.yfov = 0.8;
    expect_shadows_right(
        {.world = &world, .camera = look_at(lens, {-3.9, 1.3, 4.9}, bin), .settings = {{"shadows", "on"}}}, 6);
    // Under its own lamps edges of shadows are almost everywhere.
    const ShadowErrors errors = shadow_errors(test_device(),
                                              {.world = &lamps,
                                               .camera = lamps.cameras.at(0),
                                               .settings = {{"shadows", "on"}, {"shadow-budget", "67108864"}}},
                                              6);
    EXPECT_GE(errors.judged, 0.05);
    EXPECT_LE(errors.darkened, 0.0005);
}

// What did not change is not drawn again, and the picture is the same.
TEST(Shadows, TilesOfUnmovedLightsAreReused) {
    const ShadowGarden garden;
    Shot shot = garden.shot();
    shot.settings["shadow-budget"] = "4194304";
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    const ShadowStats first = shadows_of(*renderer, garden.camera);
    EXPECT_EQ(first.tiles_drawn, 17u); // 4 cascades, 6 and 6 faces, 1 spot
    EXPECT_EQ(first.tiles_reused, 0u);
    EXPECT_GT(first.casters_drawn, 17u);
    const Image before = renderer->read("linear");
    const ShadowStats second = shadows_of(*renderer, garden.camera);
    EXPECT_EQ(second.tiles_drawn, 0u);
    EXPECT_EQ(second.tiles_reused, 17u);
    EXPECT_TRUE(renderer->read("linear").pixels == before.pixels);

    std::vector<PlacedLight> lights = garden.world.lights;
    lights[2].position.x += 0.1;
    renderer->set_lights(lights);
    EXPECT_EQ(shadows_of(*renderer, garden.camera).tiles_drawn, 1u);
    World moved = garden.world;
    moved.lights = lights;
    Shot fresh = shot;
    fresh.world = &moved;
    EXPECT_TRUE(renderer->read("linear").pixels == render_linear(test_device(), fresh).pixels);
    PlacedCamera camera = garden.camera; // lights stay, cascades follow
    camera.position.x += 0.4;
    EXPECT_LE(shadows_of(*renderer, camera).tiles_drawn, 4u);
    expect_validation_clean(test_device());
}

// Lights that come, go and stop casting: the same bytes as a renderer made for them, wherever their tiles lie.
TEST(Shadows, LightsComeAndGo) {
    const ShadowGarden garden;
    Garden crowd;
    crowd.add_lights(40, 3, 2);
    std::vector<std::vector<PlacedLight>> steps(1, garden.world.lights);
    steps.push_back(steps[0]);
    steps[1].insert(steps[1].end(), crowd.world.lights.begin(),
                    crowd.world.lights.end()); // more than there is room for
    steps.push_back({steps[1].begin() + 1, steps[1].begin() + 9});
    steps.push_back(steps[2]);
    steps[3][0].light.casts_shadow = false;
    for (const char* memory : {"atlas", "reuse"}) {
        Shot shot = garden.shot();
        shot.width = 160, shot.height = 90;
        shot.settings["shadow-budget"] = "1048576";
        shot.settings["shadow-memory"] = memory;
        const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
        renderer->set_world(garden.world);
        for (const std::vector<PlacedLight>& lights : steps) {
            renderer->set_lights(lights);
            renderer->render(garden.camera);
            World world = garden.world;
            world.lights = lights;
            Shot fresh = shot;
            fresh.world = &world;
            EXPECT_TRUE(renderer->read("linear").pixels == render_linear(test_device(), fresh).pixels)
                << memory << ", " << lights.size() << " lights";
        }
    }
    expect_validation_clean(test_device());
}

// When the budget is short, resolution drops before shadows do, and the figures say so.
TEST(Shadows, AShortBudgetLowersResolution) {
    const ShadowGarden garden;
    uint32_t largest = ~0u;
    std::vector<bool> told;
    for (const char* budget : {"67108864", "4194304", "262144", "4096", "64"}) {
        Shot shot = garden.shot();
        shot.settings["shadow-budget"] = budget;
        const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
        renderer->set_world(garden.world);
        const ShadowStats stats = shadows_of(*renderer, garden.camera);
        EXPECT_EQ(stats.lights, 4u);
        EXPECT_EQ(stats.lights_without, 0u);
        EXPECT_LE(stats.texels, stats.budget);
        EXPECT_LE(stats.budget, std::stoull(budget));
        EXPECT_LT(stats.largest, largest);
        largest = stats.largest;
        const std::vector<std::string> notes = renderer->stats().notes;
        EXPECT_EQ(stats.lights_reduced > 0, std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
                      return note.find("less than a texel for eight pixels") != std::string::npos;
                  }));
        told.push_back(!notes.empty());
    }
    EXPECT_EQ(told, (std::vector<bool>{false, false, false, true, true})) << "what does not show is not worth a note";
    expect_validation_clean(test_device());
}

// One texel: one light with one tile may have it, all others go without and keep their light.
// Penumbrae are as wide as the light's size makes them.
TEST(Shadows, ContactTakesALightForAsLargeAsItIs) {
    ShadowGarden garden;
    garden.world.lights = {garden.world.lights[1]};
    garden.world.ambient = glm::vec3(0);
    const auto half_lit = [&](float size) {
        garden.world.lights[0].light.size = size;
        Shot shot = garden.shot();
        shot.width = 200, shot.height = 112;
        const Image open = (shot.settings = {}, render_linear(test_device(), shot));
        shot.settings = {{"shadows", "on"}, {"shadow-filter", "contact"}};
        const Image image = render_linear(test_device(), shot);
        size_t count = 0;
        for (size_t i = 0; i < image.pixels.size(); ++i)
            count += open.pixels[i].g > 0.01f && image.pixels[i].g > 0.1f * open.pixels[i].g &&
                     image.pixels[i].g < 0.9f * open.pixels[i].g;
        return count;
    };
    const size_t small = half_lit(0.002f), usual = half_lit(0.03f), large = half_lit(0.3f);
    EXPECT_GT(usual, small * 11 / 10) << small;
    EXPECT_GT(large, usual * 3 / 2) << usual;
    expect_validation_clean(test_device());
}

TEST(Shadows, ABudgetOfOneTexel) {
    const ShadowGarden garden;
    Shot shot = garden.shot();
    shot.settings["shadow-budget"] = "1";
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    const ShadowStats stats = shadows_of(*renderer, garden.camera);
    EXPECT_EQ(stats.budget, 1u);
    EXPECT_LE(stats.lights, 1u);
    EXPECT_EQ(stats.lights + stats.lights_without, 4u);
    EXPECT_THAT(renderer->stats().notes, testing::Contains(testing::HasSubstr("have no shadow")));
    World without = garden.world;
    without.lights.resize(2); // sun and point light, neither of which fits
    shot.world = &without;
    Shot off = shot;
    off.settings = {};
    EXPECT_TRUE(render_linear(test_device(), shot).pixels == render_linear(test_device(), off).pixels);
    expect_validation_clean(test_device());
}

TEST(Shadows, AThousandShadowedLights) {
    Garden garden;
    garden.add_lights(1000, 1.5f, 0.3f);
    Shot shot = garden.shot();
    shot.settings = {{"shadows", "on"}};
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    const ShadowStats stats = shadows_of(*renderer, garden.camera);
    EXPECT_GE(stats.lights, 900u); // but those off screen
    EXPECT_EQ(stats.lights_without, 0u);
    EXPECT_GE(stats.smallest, 16u);
    expect_within(
        compare_pixels(renderer->read("linear"),
                       render_reference(garden.world, garden.camera, shot.width, shot.height, 0, form_of(shot)).linear,
                       std::vector<uint8_t>(size_t(shot.width) * shot.height, 0)),
        {.psnr = 45, .off_share = 0.05, .block = 10}); // tiles of few texels: soft edges everywhere
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
