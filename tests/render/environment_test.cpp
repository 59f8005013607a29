// Environment light [materials]: every architecture and every material under a map of light from all around, against
// the reference; what it is when nothing else shines; the background.
#include "every_way.hpp"
#include "garden.hpp"
#include <cmath>
#include <numbers>
#include <prelight/material_shader.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using std::numbers::pi;

/// A sky with a sun of 12° in it, over a brown floor.
Environment sunny_sky(uint32_t width = 128) {
    Environment sky{.name = "sky", .image = Image(width, width / 2)};
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.7, 0.5, -0.4));
    for (uint32_t y = 0; y < width / 2; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const double round = ((x + 0.5) / width - 0.5) * 2 * pi, polar = (y + 0.5) / (width / 2) * pi;
            const glm::dvec3 d(std::sin(round) * std::sin(polar), std::cos(polar), -std::cos(round) * std::sin(polar));
            const double up = 0.5 + 0.5 * std::tanh(4 * d.y), near = std::exp((glm::dot(d, sun) - 1) / 0.022);
            sky.image.at(x, y) = glm::vec3(glm::mix(glm::dvec3(0.25, 0.2, 0.15), glm::dvec3(0.3, 0.5, 0.9), up) +
                                           12.0 * near * glm::dvec3(1, 0.9, 0.7));
        }
    return sky;
}

struct SkyGarden : Garden {
    SkyGarden() {
        scene.environment = std::make_shared<Environment>(sunny_sky());
        add_lights(4, 5, 4);
        world.ambient = {5, 5, 5}; // unused: the environment is in its place
    }
    Shot shot() const {
        Shot shot = Garden::shot();
        shot.width = 160;
        shot.height = 90;
        return shot;
    }
};

TEST(EnvironmentLight, AgreesInEveryArchitecture) {
    const SkyGarden garden;
    References references;
    for (const Way& way :
         std::initializer_list<Way>{{"light-prepass", {}},
                                    {"light-prepass", {{"list-shading", "fragment"}, {"normals", "oct32"}}},
                                    {"light-prepass", {{"light-culling", "volumes"}, {"ambient", "light"}}},
                                    {"deferred", {}},
                                    {"multipass", {}},
                                    {"multipass", {{"ambient", "per-object"}}},
                                    {"z-prepass", {}},
                                    {"z-prepass", {{"lights", "grid"}}}}) {
        Shot shot = garden.shot();
        shot.renderer = way.renderer;
        shot.settings = way.settings;
        if (shot.settings.contains("ambient") &&
            shot.renderer == "light-prepass") { // an environment is no light: the same picture
            shot.settings.erase("ambient");
            const Image without = render_linear(test_device(), shot);
            shot.settings["ambient"] = "light";
            EXPECT_TRUE(render_linear(test_device(), shot).pixels == without.pixels);
            continue;
        }
        references.expect_agrees(shot);
    }
}

TEST(EnvironmentLight, AgreesInPhongAndWithFresnelAtTheViewer) {
    const SkyGarden garden;
    Shot shot = garden.shot();
    shot.settings["model"] = "nv";
    expect_agrees(shot);
    shot.settings.clear();
    shot.shading = Shading::phong;
    References references;
    for (const char* renderer : {"light-prepass", "deferred", "multipass", "z-prepass"}) {
        shot.renderer = renderer;
        references.expect_agrees(shot);
    }
}

TEST(EnvironmentLight, AgreesInKillzone2sGBuffer) {
    SkyGarden garden;
    garden.world.lights.clear(); // its 8 bits are for lights: docs/deferred.md
    Shot shot = garden.shot();
    shot.renderer = "deferred";
    shot.settings["g-buffer"] = "killzone2";
    expect_agrees(shot);
}

TEST(EnvironmentLight, OfEachMaterialAgreesInEveryArchitecture) {
    SkyGarden garden;
    const char* names[] = {"skin", "minnaert", "reflection", "fresnel-rim", "layered"};
    for (size_t m = 0; m < 5; ++m)
        garden.scene.materials[m + 1].shader = find_material_shader(names[m]);
    garden.scene.materials[5].parameters = {{"clearcoat", {0.8f, 0, 0, 0}},
                                            {"clearcoat_roughness", {0.15f, 0, 0, 0}},
                                            {"sheen_colour", {0.3f, 0.2f, 0.4f, 0}},
                                            {"specular", {0.7f, 0, 0, 0}}};
    garden.world.lights.resize(2);
    for (const char* renderer : {"light-prepass", "deferred", "multipass", "z-prepass"}) {
        Shot shot = garden.shot();
        shot.renderer = renderer;
        expect_agrees(shot);
    }
}

TEST(EnvironmentLight, IsTurnedAndScaled) {
    SkyGarden garden;
    Environment turned = *garden.scene.environment;
    turned.rotation = 2.2;
    turned.intensity = 0.6f;
    garden.scene.environment = std::make_shared<Environment>(turned);
    expect_agrees(garden.shot());
}

TEST(EnvironmentLight, OcclusionTextureHoldsItBack) {
    TestWorld wall;
    Material material{.name = "wall", .metallic = 0.5f, .roughness = 0.4f, .occlusion_strength = 0.8f};
    std::vector<uint8_t> grey;
    for (int i = 0; i < 16 * 16; ++i)
        grey.insert(grey.end(), {uint8_t(17 * (i % 16)), 0, 0, 255});
    material.occlusion_texture.image = wall.add_image(16, 16, grey);
    wall.add_material(material);
    wall.add(square(2), glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(0.3, 1, 0)));
    wall.scene.environment = std::make_shared<Environment>(sunny_sky());
    Shot shot{.world = &wall.world, .camera = front_camera(4.5), .width = 96, .height = 54};
    for (const char* renderer : {"light-prepass", "deferred"}) {
        shot.renderer = renderer;
        expect_agrees(shot);
    }
}

/// All alike from everywhere: what a surface sends on has a closed form.
TEST(EnvironmentLight, OfOneColourIsWhatTheEquationSays) {
    TestWorld wall;
    Environment grey{.name = "grey", .image = Image(64, 32)};
    std::fill(grey.image.pixels.begin(), grey.image.pixels.end(), glm::vec3(0.8f, 0.4f, 0.2f));
    wall.scene.environment = std::make_shared<Environment>(grey);
    wall.add_material({.name = "wall", .base_colour = {0.5f, 0.5f, 0.5f, 1}, .metallic = 0, .roughness = 0.5f});
    wall.add(square(1));
    const Shot shot{.world = &wall.world, .camera = front_camera(1), .width = 64, .height = 64};
    for (const char* renderer : {"light-prepass", "deferred", "multipass", "z-prepass"}) {
        Shot one = shot;
        one.renderer = renderer;
        const glm::vec3 middle = render_linear(test_device(), one).at(32, 32);
        // N·V = 1: ∫ D V N·L for roughness 0.5 is 0.9159, and hardly any of it grazes.
        const double share = 0.5 + 0.04 * 0.9159 + 0.00003;
        EXPECT_NEAR(middle.r / 0.8, share, 2e-3) << renderer;
        EXPECT_NEAR(middle.g / 0.4, share, 2e-3) << renderer;
        EXPECT_NEAR(middle.b / 0.2, share, 2e-3) << renderer;
    }
}

/// The four quarters of the horizon and both poles, each of one colour.
std::shared_ptr<Environment> painted_sky() {
    auto sky = std::make_shared<Environment>(Environment{.name = "painted", .image = Image(64, 32)});
    const glm::vec3 quarters[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}; // +Z to −X, −X to −Z, −Z to +X, +X to +Z
    for (uint32_t y = 0; y < 32; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            sky->image.at(x, y) = quarters[x / 16];
    return sky;
}

/// The built-in studio, which most pictures of files are lit by: its mirrors, walls and backdrop.
TEST(EnvironmentLight, OfTheStudioAgreesInEveryArchitecture) {
    Garden garden;
    garden.scene.environment = std::make_shared<Environment>(make_environment("studio"));
    References references;
    for (const char* renderer : {"light-prepass", "deferred", "multipass", "z-prepass"}) {
        Shot shot = garden.shot();
        shot.width = 160;
        shot.height = 90;
        shot.renderer = renderer;
        references.expect_agrees(shot,
                                 {.psnr = 62}); // sharp bright boxes: what is coarse in the prefiltered maps shows
    }
}

/// A backdrop is seen instead of the map, turned and exposed as it is, and nothing is lit by it.
TEST(Background, ShowsTheBackdropWhereThereIsOne) {
    TestWorld wall;
    wall.add_material({.name = "wall", .metallic = 0});
    wall.add(square(0.5f), glm::translate(glm::dmat4(1), {0, 0, -5}));
    Environment sky{.name = "white",
                    .image = Image(64, 32),
                    .intensity = 0.5f,
                    .rotation = pi / 2,
                    .backdrop = painted_sky()->image};
    std::fill(sky.image.pixels.begin(), sky.image.pixels.end(), glm::vec3(1));
    wall.scene.environment = std::make_shared<Environment>(sky);
    Camera lens;
    lens.yfov = 0.6;
    for (const char* name : {"light-prepass", "deferred", "multipass", "z-prepass", "reference"}) {
        RenderOptions options{.width = 32, .height = 24, .exposure = -1, .views = {"linear"}};
        const auto renderer =
            create_renderer(name, std::string_view(name) == "reference" ? nullptr : &test_device(), options);
        renderer->set_world(wall.world);
        renderer->render(look_at(lens, {0, 0, 0}, {-1, 0, -1})); // turned by 90°: what stood over −Z to +X
        EXPECT_LT(glm::length(renderer->read("linear").at(16, 12) - 0.25f * glm::vec3(0, 0, 1)), 1e-3) << name;
        renderer->render(look_at(lens, {0, 0, 0}, {0, 0, -1}));
        const glm::vec3 lit = renderer->read("linear").at(16, 12);
        EXPECT_NEAR(lit.r, lit.b, 1e-3) << name << ": the white map lights the wall";
        EXPECT_NEAR(lit.r, 0.25, 0.02) << name;
    }
    expect_validation_clean(test_device());
}

TEST(Background, ShowsTheEnvironmentWhereNothingIs) {
    TestWorld speck;
    speck.add_material({.name = "speck", .metallic = 0});
    speck.add(square(0.01f), glm::translate(glm::dmat4(1), {0, 0, 5}));
    const auto sky = painted_sky();
    speck.scene.environment = sky;
    Camera lens;
    lens.yfov = 0.6;
    struct Look {
        glm::dvec3 at{0};
        double rotation;
        glm::vec3 colour{0};
    };
    for (const Look& look : {Look{{-1, 0, -1}, 0, {0, 1, 0}}, Look{{1, 0, -1}, 0, {0, 0, 1}},
                             Look{{-1, 0, -1}, pi / 2, {0, 0, 1}}, Look{{1, 0.3, 1}, 0, {1, 1, 0}}}) {
        sky->rotation = look.rotation;
        sky->intensity = 0.5f;
        for (const char* renderer : {"light-prepass", "deferred", "multipass", "z-prepass"}) {
            Shot shot{.world = &speck.world,
                      .camera = look_at(lens, {0, 0, 0}, look.at),
                      .width = 32,
                      .height = 24,
                      .renderer = renderer};
            const glm::vec3 middle = render_linear(test_device(), shot).at(16, 12);
            EXPECT_LT(glm::length(middle - 0.5f * look.colour), 1e-3)
                << renderer << " " << look.at.x << " " << look.at.z << " " << look.rotation;
        }
    }
    expect_validation_clean(test_device());
}

TEST(Background, IsToneMappedLikeEverythingAndCanBeBlack) {
    TestWorld speck;
    speck.add_material({.name = "speck", .metallic = 0});
    speck.add(square(0.01f), glm::translate(glm::dmat4(1), {0, 0, -5}));
    Environment sky{.name = "bright", .image = Image(4, 2)};
    std::fill(sky.image.pixels.begin(), sky.image.pixels.end(), glm::vec3(3, 0.5f, 0.1f));
    speck.scene.environment = std::make_shared<Environment>(sky);
    Image one(1, 1);
    one.pixels[0] = glm::vec3(6, 1, 0.2f);
    const glm::vec3 expected = tonemap(one, Tonemap::pbr_neutral).pixels[0];
    for (const bool seen : {true, false}) {
        sky.background = seen;
        speck.scene.environment = std::make_shared<Environment>(sky);
        for (const char* name : {"light-prepass", "deferred", "multipass", "z-prepass", "reference"}) {
            RenderOptions options{.width = 16, .height = 16, .exposure = 1};
            const auto renderer =
                create_renderer(name, std::string_view(name) == "reference" ? nullptr : &test_device(), options);
            renderer->set_world(speck.world);
            renderer->render(front_camera(2));
            const glm::vec3 corner = renderer->read("final").at(2, 2);
            EXPECT_LT(glm::length(corner - (seen ? expected : glm::vec3(0))), 1.0 / 255) << name;
        }
    }
}

TEST(Background, OfAnOrthographicCameraIsOneColour) {
    TestWorld speck;
    speck.add_material({.name = "speck", .metallic = 0});
    speck.add(square(0.1f));
    speck.scene.environment = std::make_shared<Environment>(sunny_sky());
    Camera lens;
    lens.kind = ProjectionKind::orthographic;
    lens.ymag = 1;
    lens.zfar = 20;
    expect_agrees({.world = &speck.world, .camera = look_at(lens, {2, 1, 3}, {0, 0, 0}), .width = 64, .height = 48});
}

TEST(EnvironmentLight, AgreesOnSwiftShader) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    const SkyGarden garden;
    Shot shot = garden.shot();
    const Comparison c = against_reference(*device, shot);
    EXPECT_GE(c.psnr, half_float_bound.psnr);
    EXPECT_LE(c.block, half_float_bound.block);
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
