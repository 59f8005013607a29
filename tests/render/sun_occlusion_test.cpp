// Valient's sun occlusion channel: the shadow of the first directional light, written once a pixel and read by the
// light pass.
#include "garden.hpp"

namespace prelight {
namespace {

/// Two suns with shadows, a point light and a spot.
struct SunnyGarden : Garden {
    SunnyGarden() {
        add_light({.kind = LightKind::directional, .colour = {1, 0.9f, 0.8f}, .intensity = 0.8f}, at(0, 5, 0),
                  {-0.5, -1, -0.3});
        add_light({.kind = LightKind::directional, .colour = {0.3f, 0.4f, 0.6f}, .intensity = 0.3f}, at(0, 5, 0),
                  {0.6, -1, -0.2});
        add_light(point(9, 7), at(-1, 2.6, 2.2));
        add_light(spot(0.6f, 12, 40), at(4, 5, 3), {-0.7, -1, -0.6});
    }
    Shot shot() const {
        Shot shot = Garden::shot();
        shot.renderer = "deferred";
        shot.settings = {
            {"g-buffer", "killzone2"}, {"shadows", "on"}, {"shadow-detail", "0.5"}, {"shadow-budget", "16777216"}};
        return shot;
    }
};

// A sun too weak to be seen takes the channel in the second picture: the first one is then filtered in the light pass.
TEST(SunOcclusion, ThePictureIsThatOfMapsReadInTheLightPass) {
    const SunnyGarden garden;
    World without = garden.world;
    PlacedLight faint = garden.world.lights[0];
    faint.light.intensity = 1e-9f;
    without.lights.insert(without.lights.begin(), faint);
    for (const char* filter : {"hard", "pcf", "contact"})
        for (const auto& [culling, memory] : {std::pair("tiles", "atlas"),
                                              {"clusters", "atlas"},
                                              {"volumes", "atlas"},
                                              {"volumes", "reuse"},
                                              {"rectangles", "reuse"},
                                              {"stencil", "reuse"},
                                              {"fullscreen", "reuse"}}) {
            Shot shot = garden.shot();
            shot.settings["light-culling"] = culling;
            shot.settings["shadow-memory"] = memory;
            shot.settings["shadow-filter"] = filter;
            SCOPED_TRACE(std::string(culling) + " " + memory + " " + filter);
            const Image channel = render_linear(test_device(), shot);
            shot.world = &without;
            const Comparison c = compare_pixels(channel, render_linear(test_device(), shot));
            expect_within(c, {.psnr = 60, .off_share = 0, .block = 0.25}); // 256 steps of one light of four
            if (std::string(filter) != "pcf")
                break; // kinds of light culling differ in nothing but where the shader stands
        }
    expect_validation_clean(test_device());
}

// The channel holds what comes past casters: the sun's light with shadows is that without them, times the channel.
TEST(SunOcclusion, TheChannelIsTheShareThatComesThrough) {
    const SunnyGarden garden;
    World sun = garden.world;
    sun.lights.resize(1);
    sun.ambient = glm::vec3(0);
    Shot shot = garden.shot();
    shot.world = &sun;
    const Image shadowed = render_linear(test_device(), shot), channel = view_of(shot, "sun-occlusion");
    shot.settings["shadows"] = "off";
    shot.settings.erase("shadow-detail");
    shot.settings.erase("shadow-budget");
    const Image open = render_linear(test_device(), shot);
    size_t dark = 0, bright = 0, between = 0;
    for (size_t i = 0; i < open.pixels.size(); ++i) {
        if (open.pixels[i].g < 0.01f)
            continue; // turned away, or nothing there
        const float share = channel.pixels[i].g;
        dark += share == 0;
        bright += share == 1;
        between += share > 0 && share < 1;
        ASSERT_NEAR(shadowed.pixels[i].g, share * open.pixels[i].g, 0.003f * open.pixels[i].g) << "pixel " << i;
    }
    EXPECT_GT(dark, 1000u);
    EXPECT_GT(bright, 10000u);
    EXPECT_GT(between, 100u);
    expect_validation_clean(test_device());
}

// Bytes hold it within their bound, as they do without shadows: Valient's own formats against shadow rays.
TEST(SunOcclusion, ThePresetAgreesWithShadowRays) {
    SunnyGarden garden;
    garden.world.lights.resize(1);
    Shot shot = garden.shot();
    shot.world = &garden.world;
    shot.width = 400, shot.height = 225;
    shot.settings["shadow-filter"] = "hard";
    shot.settings["shadow-detail"] = "8";
    shot.settings["accumulation"] = "rgba8";
    shot.settings["specular-antialiasing"] = "off";
    ReferenceForm form = form_of(shot);
    form.grey_reflectance = true; // what the layout can hold
    const ReferencePicture reference =
        render_reference(garden.world, shot.camera, shot.width, shot.height, shot.exposure, form);
    expect_within(compare_pixels(render_linear(test_device(), shot), reference.linear, reference.left_out()),
                  rgba8_bound);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
