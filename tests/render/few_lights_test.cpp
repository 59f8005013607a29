// few-lights=forward: materials walk the lights themselves. The picture is that of the light buffer, in the same form.
#include "every_way.hpp"
#include "garden.hpp"
#include <algorithm>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

Shot forward(Shot shot) {
    shot.settings["few-lights"] = "forward";
    return shot;
}

std::vector<std::string> passes_of(const Stats& stats) {
    std::vector<std::string> names;
    for (const PassStats& pass : stats.passes)
        names.push_back(pass.name);
    return names;
}

/// Lights of every kind.
struct EightLights : Garden {
    EightLights() {
        add_lights(5, 6, 4);
        add_light({.kind = LightKind::directional, .intensity = 0.4f}, {0, 0, 0}, {-0.3, -1, -0.5});
        add_light(point(std::numeric_limits<float>::infinity(), 4), {0, 4, 3});
        add_light(spot(0.5f, 8, 20), {2, 5, 3}, {-0.3, -1, -0.5});
    }
};

TEST(FewLightsForward, EveryFormAgreesWithTheReference) {
    const EightLights garden;
    ASSERT_EQ(garden.world.lights.size(), 8u);
    expect_agrees(forward(garden.shot()));
    Shot nv = forward(garden.shot());
    nv.settings["model"] = "nv";
    expect_agrees(nv);
    Shot phong = forward(garden.shot());
    phong.shading = Shading::phong;
    phong.exposure = -2;
    expect_agrees(phong);
}

TEST(FewLightsForward, TakesTwoPassesAndNoLightBuffer) {
    const EightLights garden;
    RenderOptions options = options_of(forward(garden.shot()));
    options.views = {"final"};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_THAT(passes_of(renderer->stats()), testing::ElementsAre("depth", "material and lights"));
    EXPECT_THAT(renderer->stats().notes, testing::IsEmpty());
}

TEST(FewLightsForward, ShadowsMasksUnlitAndOwnShadersAgree) {
    EightLights garden;
    Shot shadowed = forward(garden.shot());
    // As Shadows.* has them: so much detail that maps are as right as rays.
    shadowed.settings.insert({{"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}});
    Shot buffered = shadowed;
    buffered.settings.erase("few-lights");
    const Comparison same = compare(render_linear(test_device(), shadowed), render_linear(test_device(), buffered));
    expect_within(same, {.psnr = 60});
    MixedMaterials mixed;
    expect_agrees(forward(mixed.shot()));
    const ShadedGarden skin(find_material_shader("skin"));
    expect_agrees(forward(skin.shot()));
}

TEST(FewLightsForward, SamplesAgreeOnEdges) {
    const EightLights garden;
    const Shot shot = with_samples(forward(garden.shot()));
    // Shaded once a fragment, as z-prepass does: that form of the reference, with this one's Fresnel.
    Shot as_forward = shot;
    as_forward.renderer = "z-prepass";
    as_forward.settings = {{"model", "nv"}};
    Shot nv = shot;
    nv.settings["model"] = "nv";
    const ReferencePicture reference =
        render_reference(garden.world, garden.camera, shot.width, shot.height, shot.exposure, form_of(as_forward));
    expect_within_on_edges(render_linear(test_device(), nv), reference, half_float_bound, {.pixels = 400});
    expect_validation_clean(test_device());
}

// What asks for surfaces or for the light buffer gets them, and a line says so.
TEST(FewLightsForward, GivesWayWhereSurfacesAreAskedFor) {
    const EightLights garden;
    Shot shot = forward(garden.shot());
    shot.settings["ssao"] = "half";
    const Rendered rendered = render_counting_pairs(shot);
    EXPECT_THAT(passes_of(rendered.stats), testing::Contains("depth-normal"));
    EXPECT_THAT(rendered.stats.notes, testing::ElementsAre(testing::HasSubstr("few-lights=forward: with")));
    Shot without = shot;
    without.settings.erase("few-lights");
    EXPECT_TRUE(rendered.linear.pixels == render_linear(test_device(), without).pixels);
}

// A ninth light fills a light buffer, and one less does not: each picture is a new renderer's.
TEST(FewLightsForward, FollowsTheNumberOfLights) {
    Garden garden;
    garden.add_lights(12, 6, 4);
    World world = garden.world;
    Shot shot = forward(garden.shot());
    shot.world = &world;
    const std::vector<PlacedLight> all = world.lights;
    const auto kept = create_renderer(shot.renderer, &test_device(), options_of(shot));
    kept->set_world(world);
    for (const size_t count : {12, 8, 9, 3, 0}) {
        world.lights.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
        kept->set_lights(world.lights);
        kept->render(shot.camera);
        EXPECT_TRUE(kept->read("linear").pixels == render_linear(test_device(), shot).pixels) << count;
        const std::vector<std::string> names = passes_of(kept->stats());
        EXPECT_EQ(std::ranges::count(names, "material and lights"), count <= 8) << count;
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
