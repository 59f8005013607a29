// The maps of `detailed` and the environment of `reflection`, against the reference.
#include "garden.hpp"
#include <cmath>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

/// A wall with the maps of `detailed`: a dome of height, detail normals, a mask, gloss, incandescence.
struct ReliefWall : TestWorld {
    template <class F>
    uint32_t map(F value) {
        constexpr uint32_t size = 64;
        std::vector<uint8_t> rgba;
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                const glm::vec3 v = value((x + 0.5f) / size * 6.2831853f, (y + 0.5f) / size * 6.2831853f);
                for (int c = 0; c < 3; ++c)
                    rgba.push_back(static_cast<uint8_t>(std::lround(255 * glm::clamp(v[c], 0.0f, 1.0f))));
                rgba.push_back(255);
            }
        return add_image(size, size, std::move(rgba));
    }

    ReliefWall() {
        Material material{.name = "wall", .metallic = 0, .roughness = 0.5f};
        material.shader = find_material_shader("detailed");
        material.base_colour_texture.image =
            map([](float u, float v) { return glm::vec3(0.5f + 0.3f * std::sin(u), 0.5f + 0.3f * std::cos(v), 0.4f); });
        material.normal_texture.image = map([](float u, float v) {
            return glm::normalize(glm::vec3(0.2f * std::sin(u), 0.2f * std::sin(v), 1)) * 0.5f + 0.5f;
        });
        heights = map([](float u, float v) { return glm::vec3(0.5f + 0.25f * std::sin(u) + 0.25f * std::cos(v)); });
        detail = map([](float u, float v) {
            return glm::normalize(glm::vec3(0.3f * std::sin(3 * u), 0.3f * std::cos(2 * v), 1)) * 0.5f + 0.5f;
        });
        grey = map([](float u, float) { return glm::vec3(0.5f + 0.5f * std::sin(u)); });
        add_material(material);
        add(square(2), glm::rotate(glm::dmat4(1), 0.6, glm::dvec3(0.3, 1, 0)));
        add_light({.kind = LightKind::point, .intensity = 14, .range = 9}, {1.5, 1, 2});
        add_light({.kind = LightKind::point, .colour = {0.5f, 0.7f, 1}, .intensity = 10, .range = 9}, {-1.5, -1, 1.5});
        world.ambient = {0.1f, 0.1f, 0.1f};
    }
    Material& wall() { return scene.materials[0]; }
    Shot shot() const { return {.world = &world, .camera = front_camera(4.5)}; }
    uint32_t heights, detail, grey;
};

TEST(Maps, ParallaxAgreesWithTheReference) {
    ReliefWall wall;
    wall.wall().textures["height_map"] = {.image = wall.heights};
    wall.wall().parameters["depth"] = glm::vec4(0.06f);
    expect_agrees(wall.shot());
    wall.wall().double_sided = true; // from behind, and mirrored
    wall.world.instances[0].transform =
        glm::rotate(glm::dmat4(1), 2.6, glm::dvec3(0, 1, 0)) * glm::scale(glm::dmat4(1), {-1, 1, 1});
    wall.world.instances[0].mirrored = true;
    expect_agrees(wall.shot());
}

TEST(Maps, ParallaxOcclusionAgreesWithTheReference) {
    ReliefWall wall;
    wall.wall().textures["height_map"] = {.image = wall.heights};
    wall.wall().parameters = {{"depth", glm::vec4(0.1f)}, {"occlusion_steps", glm::vec4(24)}};
    expect_agrees(wall.shot());
}

TEST(Maps, DetailNormalsUnderAMaskGlossAndIncandescenceAgree) {
    ReliefWall wall;
    wall.wall().textures = {{"detail_normal_map", {.image = wall.detail}}, {"detail_mask", {.image = wall.grey}}};
    wall.wall().parameters["detail"] = glm::vec4(0.7f);
    expect_agrees(wall.shot());
    wall.wall().textures = {{"gloss_map", {.image = wall.grey}}, {"incandescence_map", {.image = wall.detail}}};
    wall.wall().parameters = {{"incandescence", glm::vec4(0.5f)}, {"gloss_roughness", glm::vec4(0.4f)}};
    for (const char* renderer : {"light-prepass", "z-prepass", "deferred"}) {
        Shot shot = wall.shot();
        shot.renderer = renderer;
        expect_agrees(shot);
    }
}

TEST(Maps, GlossDimsSpecularLightDownToNothing) {
    // A metal sends on nothing else: black where gloss is, half of it where that is half.
    const auto lit = [](uint8_t gloss, float rough, const char* renderer, bool reference) {
        TestWorld world;
        Material metal{.name = "metal", .metallic = 1, .roughness = 0.5f};
        metal.shader = find_material_shader("detailed");
        metal.textures["gloss_map"] = {.image = world.add_image(1, 1, {gloss, gloss, gloss, 255})};
        metal.parameters["gloss_roughness"] = glm::vec4(rough);
        world.add_material(metal);
        world.add(square(1));
        world.add_light({.kind = LightKind::point, .intensity = 9, .range = 9}, {0.2, 0.3, 2});
        world.world.ambient = {0.3f, 0.2f, 0.1f};
        const Shot shot{
            .world = &world.world, .camera = front_camera(2), .width = 32, .height = 32, .renderer = renderer};
        return reference ? render_reference(world.world, shot.camera, 32, 32, 0, form_of(shot)).linear.at(16, 16)
                         : render_linear(test_device(), shot).at(16, 16);
    };
    for (const char* renderer : {"light-prepass", "z-prepass", "multipass"})
        for (const bool reference : {false, true}) {
            const glm::vec3 whole = lit(255, 0, renderer, reference), half = lit(128, 0, renderer, reference),
                            none = lit(0, 0, renderer, reference);
            EXPECT_GT(whole.r, 0.5f) << renderer;
            for (int c = 0; c < 3; ++c) {
                EXPECT_EQ(none[c], 0) << renderer;
                EXPECT_NEAR(half[c], whole[c] * 128 / 255, 0.004f * whole[c]) << renderer;
                EXPECT_LT(lit(128, 1, renderer, reference)[c], 0.9f * half[c]) << "and rough where it is asked to be";
            }
        }
}

TEST(Maps, GlossDimsReflectanceInAGBuffer) {
    ReliefWall wall;
    wall.wall().metallic = 0.7f;
    wall.wall().textures = {{"gloss_map", {.image = wall.grey}}};
    Shot shot = wall.shot();
    shot.renderer = "deferred";
    expect_agrees(shot);
    shot.shading = Shading::phong;
    shot.exposure = -1;
    expect_agrees(shot);
}

TEST(Maps, DetailColourAgreesUnderAMask) {
    ReliefWall wall;
    wall.wall().textures = {{"detail_map", {.image = wall.detail}}, {"detail_mask", {.image = wall.grey}}};
    wall.wall().parameters["detail_colour"] = glm::vec4(0.6f);
    for (const char* renderer : {"light-prepass", "z-prepass", "multipass", "deferred"}) {
        Shot shot = wall.shot();
        shot.renderer = renderer;
        expect_agrees(shot);
    }
    // The middle of what a code can say changes nothing; nor does any where the mask is black.
    ReliefWall plain;
    plain.wall().parameters.clear();
    const Image before = render_linear(test_device(), plain.shot());
    plain.wall().textures = {{"detail_map", {.image = plain.add_image(1, 1, {128, 128, 128, 255})}}};
    const Image grey = render_linear(test_device(), plain.shot());
    plain.wall().textures = {{"detail_map", {.image = plain.detail}},
                             {"detail_mask", {.image = plain.add_image(1, 1, {0, 0, 0, 255})}}};
    const Image masked = render_linear(test_device(), plain.shot());
    for (size_t i = 0; i < before.pixels.size(); ++i) {
        EXPECT_NEAR(grey.pixels[i].g, before.pixels[i].g, 0.002f + 0.002f * before.pixels[i].g);
        EXPECT_NEAR(masked.pixels[i].g, before.pixels[i].g, 0.002f + 0.002f * before.pixels[i].g);
    }
}

TEST(Maps, EachChangesThePicture) {
    ReliefWall plain;
    const Image before = render_linear(test_device(), plain.shot());
    for (const char* name : {"height_map", "detail_normal_map", "gloss_map", "incandescence_map", "detail_map"}) {
        ReliefWall wall;
        wall.wall().textures[name] = {.image = std::string_view(name) == "height_map" ? wall.heights : wall.detail};
        EXPECT_FALSE(render_linear(test_device(), wall.shot()).pixels == before.pixels) << name;
    }
}

/// A sky whose mirrored picture a prefiltered map can hold.
std::shared_ptr<const Environment> smooth_sky() {
    auto sky = std::make_shared<Environment>(Environment{.name = "sky", .image = Image(256, 128)});
    for (uint32_t y = 0; y < 128; ++y)
        for (uint32_t x = 0; x < 256; ++x) {
            const float round = (x + 0.5f) / 256 * 6.2831853f, down = (y + 0.5f) / 128 * 3.14159265f;
            const float flat = std::sin(down);
            sky->image.at(x, y) =
                glm::vec3(1 + flat * std::sin(round), 1.2f + std::cos(down), 0.9f + 0.5f * flat * std::cos(round));
        }
    return sky;
}

TEST(Reflection, ShowsTheEnvironmentAsTheReferenceDoes) {
    for (const float roughness : {0.0f, 1.0f / 3, 2.0f / 3}) { // where levels lie
        ShadedGarden garden(find_material_shader("reflection"));
        garden.scene.environment = smooth_sky();
        for (Material& material : garden.scene.materials)
            material.roughness = roughness;
        expect_agrees(garden.shot());
    }
}

TEST(Layers, OfGltfAgreeInEveryArchitecture) {
    ShadedGarden garden(find_material_shader("layered"));
    const std::map<std::string, glm::vec4> looks[]{
        {{"ior", {1.8f, 0, 0, 0}}},
        {{"specular", {0.4f, 0, 0, 0}}, {"specular_colour", {3, 0.5f, 1, 0}}},
        {{"clearcoat", {1, 0, 0, 0}}, {"clearcoat_roughness", {0.3f, 0, 0, 0}}},
        {{"sheen_colour", {0.8f, 0.6f, 0.9f, 0}}, {"sheen_roughness", {0.6f, 0, 0, 0}}},
        {{"clearcoat", {0.5f, 0, 0, 0}},
         {"clearcoat_roughness", {0.25f, 0, 0, 0}},
         {"sheen_colour", {0.2f, 0.1f, 0.4f, 0}}}};
    for (size_t m = 1; m < garden.scene.materials.size(); ++m)
        garden.scene.materials[m].parameters = looks[m - 1];
    for (const char* renderer : {"light-prepass", "z-prepass", "multipass", "deferred"}) {
        Shot shot = garden.shot();
        shot.renderer = renderer;
        expect_agrees(shot);
    }
}

TEST(Layers, WithMapsAgree) {
    ReliefWall wall;
    Material& material = wall.wall();
    material.shader = find_material_shader("layered");
    material.parameters = {{"clearcoat", glm::vec4(1)},
                           {"clearcoat_roughness", glm::vec4(0.5f)},
                           {"sheen_colour", glm::vec4(0.7f)},
                           {"sheen_roughness", glm::vec4(0.8f)}};
    material.textures = {
        {"specular_map", {.image = wall.grey}},       {"specular_colour_map", {.image = wall.detail}},
        {"clearcoat_map", {.image = wall.grey}},      {"clearcoat_roughness_map", {.image = wall.heights}},
        {"sheen_colour_map", {.image = wall.detail}}, {"sheen_roughness_map", {.image = wall.grey}}};
    expect_agrees(wall.shot());
}

TEST(Reflection, IsPutWhereTheDirectionIs) {
    ShadedGarden garden(find_material_shader("reflection"));
    auto sky = std::make_shared<Environment>(Environment{.name = "sky", .image = Image(64, 32)});
    for (uint32_t y = 0; y < 32; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            sky->image.at(x, y) = y < 16 ? glm::vec3(1, 0, 0) : x < 32 ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    garden.scene.environment = sky;
    for (Material& material : garden.scene.materials)
        material = {.name = "mirror", .metallic = 1, .roughness = 0, .shader = find_material_shader("reflection")};
    garden.world.lights.clear();
    garden.world.ambient = {};
    const Image picture = render_linear(test_device(), garden.shot());
    // The floor under a camera that looks down at −Z: its mirror shows the upper half.
    const glm::vec3 floor = picture.at(160, 170);
    EXPECT_NEAR(floor.r, 1, 0.03);
    EXPECT_NEAR(floor.g + floor.b, 0, 0.01);
}

} // namespace
} // namespace prelight
