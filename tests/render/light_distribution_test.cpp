// Cookies and measured profiles of lights against the reference, in every architecture.
#include "every_way.hpp"
#include "garden.hpp"
#include "vulkan_calls.hpp"
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>
#include <prelight/scene_io.hpp>
#include <prelight/vary.hpp>
#include <resident/map_levels.hpp>
#include <scene/procedural/cookie_maps.hpp>

namespace prelight {
namespace {

/// Equirectangular, so coarse that one sees between which texels it is mixed.
TextureImage patches() {
    TextureImage image{"patches", 24, 12, {}};
    uint32_t state = 7;
    for (uint32_t i = 0; i < 24 * 12; ++i) {
        state = state * 1664525u + 1013904223u;
        image.rgba.insert(image.rgba.end(), {uint8_t(state >> 24), uint8_t(state >> 16), uint8_t(state >> 20), 255});
    }
    return image;
}

/// A garden with a light of each kind that has a cookie or a profile, and two that have none.
struct CookieGarden : Garden {
    CookieGarden() : CookieGarden(glm::dvec3(0)) {}
    explicit CookieGarden(glm::dvec3 origin) : Garden(origin) {
        scene.images = {window_cookie(), patches(), dice_cookie()};
        Light window = spot(0.6f, 14, 70);
        window.inner_cone = 0.55f;
        window.cookie = 0;
        turned(window, at(3, 5.5, 4), {-0.5, -1, -0.7}, {0.2, 1, 0.1});
        Light lantern = point(9, 9);
        lantern.cookie = 1;
        turned(lantern, at(-2.5, 2.4, 2.4), {-0.5, 1.2, -0.3}, {0.3, 0.5, -1}); // where it goes round lies on the floor
        Light dice = point(8, 8, {0.8f, 0.9f, 1});
        dice.cookie = 2;
        turned(dice, at(2.2, 2.6, -1), {-0.6, 0.2, -1}, {0.1, 1, 0.4});
        Light lamp = point(9, 8, {1, 0.8f, 0.6f});
        lamp.profile = wall_lamp();
        turned(lamp, at(-4, 3, -2), {0.3, -1, 0.2}, {1, 0, 0});
        Light stage = spot(0.8f, 12, 0.06f);
        stage.profile = wall_lamp();
        stage.profile_candela = true;
        stage.cookie = 0;
        turned(stage, at(0, 5, 0.5), {0.1, -1, 0.1}, {0, 0.2, -1});
        add_light(point(5, 2), at(4.5, 1.4, 2.5));
        add_light({.kind = LightKind::directional, .colour = {0.5f, 0.6f, 1}, .intensity = 0.15f}, at(0, 0, 0),
                  {0.4, -1, -0.5});
    }
    Shot shot() const {
        Shot shot = Garden::shot();
        shot.width = 256, shot.height = 144;
        return shot;
    }

private:
    void turned(const Light& light, glm::dvec3 place, glm::dvec3 direction, glm::dvec3 up) {
        add_light(light, place, direction).up = up;
    }
};

TEST(LightDistributions, EveryArchitectureAgreesWithTheReference) {
    const CookieGarden garden;
    const Shot form = garden.shot();
    const ReferencePicture reference =
        render_reference(garden.world, garden.camera, form.width, form.height, 0,
                         {.fresnel = ReferenceForm::Fresnel::nv, .specular_antialiasing = true});
    World plain = garden.world;
    for (PlacedLight& light : plain.lights)
        light.light.cookie = no_cookie, light.light.profile = nullptr, light.light.profile_candela = false;
    const ReferencePicture without =
        render_reference(plain, garden.camera, form.width, form.height, 0,
                         {.fresnel = ReferenceForm::Fresnel::nv, .specular_antialiasing = true});
    EXPECT_LT(compare_pixels(without.linear, reference.linear, reference.left_out()).psnr, 25)
        << "the scene has something to compare";
    for (const Shot& shot : every_way(form)) {
        SCOPED_TRACE(name_of(shot));
        const Image image = render_linear(test_device(), shot);
        expect_within(compare_pixels(image, reference.linear, reference.left_out()), half_float_bound);
    }
    expect_validation_clean(test_device());
}

TEST(LightDistributions, EachKindAgreesWithTheReference) {
    const CookieGarden garden;
    for (size_t i = 0; i < 5; ++i)
        for (const Shading shading : {Shading::ggx, Shading::phong}) {
            SCOPED_TRACE(i);
            World world = garden.world;
            world.lights = {garden.world.lights[i]};
            Shot shot = garden.shot();
            shot.world = &world;
            shot.shading = shading;
            expect_agrees(shot);
        }
}

TEST(LightDistributions, WithShadows) {
    CookieGarden garden;
    for (const size_t i : {2, 4, 5, 6}) // fewer edges of shadows to leave out
        garden.world.lights[i].light.casts_shadow = false;
    Shot shot = garden.shot();
    shot.width = 320, shot.height = 180;
    shot.settings = {
        {"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}, {"shadow-budget", "16777216"}};
    References references;
    for (const std::string& renderer : device_renderers) {
        shot.renderer = renderer;
        references.expect_agrees(shot);
    }
}

TEST(LightDistributions, InAnOrthographicViewAndFarFromTheOrigin) {
    CookieGarden garden;
    garden.camera.camera.kind = ProjectionKind::orthographic;
    garden.camera.camera.ymag = 4;
    garden.camera.camera.zfar = 40;
    expect_agrees(garden.shot());
    const CookieGarden away(glm::dvec3(9000, 200, -7000));
    expect_agrees(away.shot());
}

// A coarse picture of a fine pattern: what the pixels of a picture eight times as fine have in the mean.
TEST(LightDistributions, SmallCookiesDoNotAlias) {
    CookieGarden garden;
    TextureImage checks{"checks", 512, 512, {}};
    for (uint32_t i = 0; i < 512 * 512; ++i)
        checks.rgba.insert(checks.rgba.end(), 3, (i % 512 / 4 + i / 512 / 4) % 2 ? 255 : 0), checks.rgba.push_back(255);
    TextureImage round = checks;
    round.height = 256;
    round.rgba.resize(512 * 256 * 4);
    garden.scene.images = {
        checks,
        round,
        {"strip", 384, 64, std::vector<uint8_t>(checks.rgba.begin(), checks.rgba.begin() + 384 * 64 * 4)}};
    for (size_t i = 0; i < 3; ++i) {
        SCOPED_TRACE(i);
        World world = garden.world;
        world.lights = {garden.world.lights[i]};
        Shot shot = garden.shot();
        shot.world = &world;
        shot.width = 64, shot.height = 36;
        expect_agrees(shot, {.left_out = 0.3});
        const Image coarse = render_linear(test_device(), shot);
        const Image fine = render_reference(world, garden.camera, 512, 288, 0, {}).linear;
        const ReferencePicture seen = render_reference(world, garden.camera, 64, 36, 0, {});
        const std::vector<uint8_t> edges = seen.left_out();
        double difference = 0, sum = 0;
        for (uint32_t y = 0; y < 36; ++y)
            for (uint32_t x = 0; x < 64; ++x) {
                if (edges[y * 64 + x] || seen.instance[y * 64 + x] != 0) // the floor
                    continue;
                double mean = 0;
                for (uint32_t k = 0; k < 64; ++k)
                    mean += fine.pixels[(8 * y + k / 8) * 512 + 8 * x + k % 8].g / 64.0;
                difference += std::abs(mean - coarse.pixels[y * 64 + x].g);
                sum += mean;
            }
        EXPECT_LT(difference, 0.12 * sum);
    }
}

TEST(LightDistributions, ACookieTurnsWithItsNode) {
    const Scene scene = make_scene("cookies", 7, 1);
    Image before;
    for (const double time : {0.0, 1.0}) {
        const World world = resolve(scene, {}, Moment{time});
        const Shot shot{.world = &world, .camera = find_camera(world, "lantern"), .width = 256, .height = 144};
        expect_agrees(shot);
        const Image image = render_linear(test_device(), shot);
        EXPECT_FALSE(image.pixels == before.pixels);
        before = image;
    }
}

TEST(LightDistributions, AreThoseThatSetLightsBrings) {
    const CookieGarden garden;
    World plain = garden.world;
    plain.lights.resize(7);
    for (PlacedLight& light : plain.lights)
        light.light.cookie = no_cookie, light.light.profile = nullptr, light.light.profile_candela = false;
    for (const char* culling : {"volumes", "tiles"}) {
        Shot shot = garden.shot();
        shot.settings["light-culling"] = culling;
        const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
        renderer->set_world(plain);
        renderer->render(garden.camera);
        EXPECT_FALSE(renderer->read("linear").pixels == render_linear(test_device(), shot).pixels);
        std::vector<PlacedLight> wrong = garden.world.lights;
        wrong[0].light.cookie = 77;
        EXPECT_THROW(renderer->set_lights(wrong), Error);
        renderer->render(garden.camera); // as before
        renderer->set_lights(garden.world.lights);
        renderer->render(garden.camera);
        EXPECT_TRUE(renderer->read("linear").pixels == render_linear(test_device(), shot).pixels);
        std::vector<PlacedLight> more = garden.world.lights;
        for (int i = 0; i < 40; ++i)
            more.push_back({garden.world.lights[2].light, garden.at(0.2 * i - 4, 1, 2)});
        renderer->set_lights(more);
        renderer->render(garden.camera);
        World crowd = garden.world;
        crowd.lights = more;
        shot.world = &crowd;
        EXPECT_TRUE(renderer->read("linear").pixels == render_linear(test_device(), shot).pixels);
    }
    expect_validation_clean(test_device());
}

TEST(LightDistributions, WrongOnesAreRefusedByEveryRenderer) {
    for (const auto& [change, reason] : std::vector<std::pair<std::function<void(CookieGarden&)>, std::string>>{
             {[](CookieGarden& g) { g.world.lights[0].light.cookie = 9; }, "test: light : cookie: there is no image 9"},
             {[](CookieGarden& g) { g.world.lights[1].light.cookie = 0; }, "is neither 2:1 (equirectangular) nor 6:1"},
             {[](CookieGarden& g) { g.world.lights[0].light.outer_cone = 1.5f; }, "wider than a picture can be thrown"},
             {[](CookieGarden& g) { g.world.lights[6].light.profile = wall_lamp(); },
              "a directional light has no profile"},
             {[](CookieGarden& g) { g.world.lights[5].light.size = 0; }, "size 0 is no radius"},
             {[](CookieGarden& g) { g.scene.images[0].rgba.clear(); }, "image 0 has no pixels"}}) {
        CookieGarden garden;
        change(garden);
        for (const RendererInfo& info : renderer_infos()) {
            Shot shot = garden.shot();
            const auto renderer =
                create_renderer(info.name, info.needs_device ? &test_device() : nullptr, {.width = 64, .height = 36});
            try {
                renderer->set_world(garden.world);
                ADD_FAILURE() << info.name << " takes it";
            } catch (const Error& error) {
                EXPECT_THAT(error.what(), testing::HasSubstr(reason)) << info.name;
            }
        }
    }
}

TEST(LightDistributions, ASteadyFrameMakesNothing) {
    CookieGarden garden;
    for (const auto& [renderer, setting, value] : {std::tuple("light-prepass", "light-culling", "volumes"),
                                                   {"light-prepass", "light-culling", "tiles"},
                                                   {"deferred", "light-culling", "clusters"},
                                                   {"z-prepass", "lights", "grid"}}) {
        SCOPED_TRACE(renderer + std::string(" ") + value);
        Shot shot = garden.shot();
        shot.renderer = renderer;
        shot.settings = {{setting, value}};
        const auto one = create_renderer(shot.renderer, &test_device(), options_of(shot));
        one->set_world(garden.world);
        std::vector<PlacedLight> lights = garden.world.lights;
        for (int frame = 0; frame < 6; ++frame) {
            const VulkanCalls calls;
            rotate_lights(lights, garden.at(0, 0, 0), 0.05);
            one->set_lights(lights);
            one->render(garden.camera);
            const Stats stats = one->stats();
            if (frame < 3)
                continue;
            EXPECT_EQ(calls.pipelines + calls.allocations + calls.buffers + calls.images + calls.descriptor_pools, 0u)
                << "frame " << frame;
            EXPECT_EQ(stats.created, CreatedObjects{}) << "frame " << frame;
        }
    }
    expect_validation_clean(test_device());
}

// What is uploaded for a profile holds its own values where even steps meet its angles.
TEST(ProfileLevel, HoldsTheProfilesOwnValues) {
    const LightProfile odd = parse_profile(
        "TILT=NONE\n1 1 1 4 4 1 2 0 0 0 1 1 0\n0 7.5 30 90 0 60 90 180\n10 20 30 40 1 2 3 4 5 6 7 8 9 10 11 80\n", "a");
    const Image level = resident::profile_level(odd); // a texel more on each side
    EXPECT_EQ(level.height - 2, 13u);                 // steps of 7.5°
    EXPECT_EQ(level.width - 2, 12u);                  // of 30°
    const auto at = [&](uint32_t column, uint32_t row) {
        return level.pixels[(row + 1) * level.width + column + 1].r * 80;
    };
    EXPECT_FLOAT_EQ(at(0, 0), 10);
    EXPECT_FLOAT_EQ(at(0, 1), 20);
    EXPECT_FLOAT_EQ(at(0, 4), 30);
    EXPECT_FLOAT_EQ(at(2, 12), 4);
    EXPECT_FLOAT_EQ(at(6, 12), 80);
    EXPECT_FLOAT_EQ(at(9, 1), 6);
    EXPECT_FLOAT_EQ(at(12, 1), 20) << "past the last column comes the first";
    EXPECT_FLOAT_EQ(at(1, 0), 5.5);
}

} // namespace
} // namespace prelight
