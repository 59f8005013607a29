// The material `specular-glossiness`: against the closed form, against metallic-roughness that says the same, and
// against the reference in every architecture.
#include "garden.hpp"
#include <cmath>
#include <numbers>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

Material made_of(glm::vec3 diffuse, glm::vec3 f0, float glossiness) {
    Material m{.name = "surface", .base_colour = glm::vec4(diffuse, 1), .metallic = 0, .roughness = 1 - glossiness};
    m.shader = find_material_shader("specular-glossiness");
    m.parameters = {{"specular", glm::vec4(f0, 0)}, {"glossiness", glm::vec4(glossiness)}};
    return m;
}

/// A wall of one material under a directional light that shines along the view.
struct WallOfOneMaterial : TestWorld {
    explicit WallOfOneMaterial(const Material& material) {
        add_material(material);
        add(square(2));
        add_light({.kind = LightKind::directional, .intensity = 3}, {0, 0, 1}, {0, 0, -1});
    }
    Shot shot(const char* renderer) const {
        return {.world = &world, .camera = front_camera(3), .width = 65, .height = 65, .renderer = renderer};
    }
    glm::vec3 middle(const char* renderer) const {
        return std::string_view(renderer) == "reference"
                   ? render_reference(world, front_camera(3), 65, 65, 0, form_of(shot("light-prepass")))
                         .linear.at(32, 32)
                   : render_linear(test_device(), shot(renderer)).at(32, 32);
    }
};

/// N = L = V at full roughness: D = 1/π, V = 1/4, Fresnel F0.
glm::dvec3 closed_form(glm::dvec3 diffuse, glm::dvec3 f0) {
    const double scattered = 1 - std::max({f0.r, f0.g, f0.b});
    return 3.0 * (diffuse * scattered * (1.0 - f0) + f0 / 4.0) / std::numbers::pi;
}

void expect_near(glm::vec3 a, glm::dvec3 b, double share) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(a[c], b[c], share * std::max(b[c], 0.01)) << "channel " << c;
}

TEST(SpecularGlossiness, MatchesTheClosedForm) {
    for (const auto& [diffuse, f0] :
         std::initializer_list<std::pair<glm::vec3, glm::vec3>>{{{0.8f, 0.1f, 0.1f}, {0.04f, 0.04f, 0.04f}},
                                                                {{0.2f, 0.3f, 0.8f}, {0.9f, 0.6f, 0.1f}},
                                                                {{0, 0, 0}, {1, 0.75f, 0.25f}},
                                                                {{0.5f, 0.5f, 0.5f}, {0, 0, 0}}}) {
        const WallOfOneMaterial wall(made_of(diffuse, f0, 0));
        for (const char* renderer : {"reference", "light-prepass", "z-prepass", "multipass"}) {
            SCOPED_TRACE(renderer);
            expect_near(wall.middle(renderer), closed_form(diffuse, f0), 0.003);
        }
    }
}

TEST(SpecularGlossiness, ReadsBothMaps) {
    WallOfOneMaterial wall(made_of({0.5f, 1, 1}, {1, 0.5f, 1}, 0));
    wall.scene.materials[0].base_colour_texture.image = wall.add_image(1, 1, {188, 188, 92, 255});
    wall.scene.materials[0].textures["specular_glossiness_map"] = {.image = wall.add_image(1, 1, {92, 188, 92, 255})};
    const auto linear = [](int code) { return std::pow((code / 255.0 + 0.055) / 1.055, 2.4); };
    const glm::dvec3 diffuse(0.5 * linear(188), linear(188), linear(92)), f0(linear(92), 0.5 * linear(188), linear(92));
    for (const char* renderer : {"reference", "light-prepass", "z-prepass", "multipass"}) {
        SCOPED_TRACE(renderer);
        expect_near(wall.middle(renderer), closed_form(diffuse, f0), 0.01); // lavapipe decodes sRGB by a table
    }
}

// What glTF's metallic-roughness can say is the same picture, deferred shading included.
TEST(SpecularGlossiness, IsMetallicRoughnessWhereThatSaysTheSame) {
    struct Pair {
        Material own, plain;
    };
    const auto plain = [](glm::vec3 base, float metallic, float roughness) {
        return Material{
            .name = "plain", .base_colour = glm::vec4(base, 1), .metallic = metallic, .roughness = roughness};
    };
    // base (1 − m) and 0.04 (1 − m) + base m
    const auto mixed = [&](float base, float m, float roughness) {
        const float f0 = 0.04f * (1 - m) + base * m, diffuse = base * (1 - m) / (1 - f0);
        return Pair{made_of(glm::vec3(diffuse), glm::vec3(f0), 1 - roughness), plain(glm::vec3(base), m, roughness)};
    };
    for (const Pair& pair :
         {Pair{made_of({0.5f, 0.25f, 0.125f}, glm::vec3(0.04f), 0.5f), plain(glm::vec3(0.48f, 0.24f, 0.12f), 0, 0.5f)},
          Pair{made_of({0, 0, 0}, {0.9f, 0.6f, 0.2f}, 0.6f), plain({0.9f, 0.6f, 0.2f}, 1, 0.4f)},
          mixed(0.6f, 0.5f, 0.4f), mixed(0.5f, 0.2f, 0.7f)}) {
        Garden own, same;
        for (Garden* garden : {&own, &same}) {
            garden->add_lights(6, 5, 6);
            for (size_t m = 1; m < garden->scene.materials.size(); ++m)
                garden->scene.materials[m] = garden == &own ? pair.own : pair.plain;
        }
        for (const std::string& renderer : device_renderers) {
            SCOPED_TRACE(renderer);
            Shot a = own.shot(), b = same.shot();
            a.renderer = b.renderer = renderer;
            const Image first = render_linear(test_device(), a), second = render_linear(test_device(), b);
            EXPECT_GE(compare_pixels(first, second, std::vector<uint8_t>(first.pixels.size(), 0)).psnr, 55);
        }
    }
}

TEST(SpecularGlossiness, AgreesWithTheReferenceInEveryArchitecture) {
    Garden garden;
    garden.add_lights(6, 5, 6);
    const glm::vec3 looks[][2] = {{{0.8f, 0.2f, 0.1f}, {0.04f, 0.04f, 0.04f}},
                                  {{0.1f, 0.1f, 0.4f}, {0.7f, 0.5f, 0.3f}},
                                  {{0, 0, 0}, {1, 0.8f, 0.3f}},
                                  {{0.6f, 0.6f, 0.6f}, {0, 0, 0}},
                                  {{0.3f, 0.7f, 0.2f}, {0.2f, 0.5f, 0.1f}}};
    for (size_t m = 1; m < garden.scene.materials.size(); ++m)
        garden.scene.materials[m] = made_of(looks[(m - 1) % 5][0], looks[(m - 1) % 5][1], 0.2f * float(m));
    garden.world.ambient = glm::vec3(0.1f);
    for (const std::string& renderer : device_renderers) {
        SCOPED_TRACE(renderer);
        Shot shot = garden.shot();
        shot.renderer = renderer;
        expect_agrees(shot);
        shot.shading = Shading::phong;
        expect_agrees(shot);
    }
}

} // namespace
} // namespace prelight
