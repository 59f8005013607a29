// Light on blended surfaces, and what they do to the light of others.
#include "panes.hpp"
#include <gtest/gtest.h>
#include <prelight/material_shader.hpp>

namespace prelight {
namespace {

using Transparency = ReferenceForm::Transparency;
using Shadows = ReferenceForm::TransparentShadows;

/// A room of opaque things under every kind of light, in which a pane stands.
struct Room : TestWorld {
    Room(bool pane, AlphaMode mode = AlphaMode::blend, bool bumps = true, const char* shader = "") {
        world.ambient = {0.1f, 0.2f, 0.3f};
        scene.environment = surroundings([](size_t i) { return glm::vec3(0.02f * static_cast<float>(i), 0.1f, 0.2f); });
        add_material({.base_colour = {0.8f, 0.6f, 0.4f, 1}, .metallic = 0, .roughness = 0.6f});
        add(square(9), at_height(-3));
        add(sphere(24), glm::scale(at_height(-1), glm::dvec3(1.5)));
        Material glass{.base_colour = {0.3f, 0.7f, 0.9f, 0.4f},
                       .metallic = 0.3f,
                       .roughness = 0.4f,
                       .emissive = {0.2f, 0, 0.1f},
                       .alpha_mode = mode};
        if (*shader)
            glass.shader = find_material_shader(shader);
        if (bumps)
            glass.normal_texture.image =
                add_image(2, 2, {128, 128, 255, 255, 160, 128, 240, 255, 128, 160, 240, 255, 100, 110, 240, 255});
        add_material(glass);
        if (pane)
            add(square(6), glm::rotate(at_height(1.5), 0.2, glm::dvec3(0, 1, 0)));
        add_material({.base_colour = {0.9f, 0.1f, 0.1f, 0.8f}, .roughness = 0.2f});
        world.decals.push_back({{.material = 2}, glm::scale(at_height(1.5), glm::dvec3(4, 4, 2))}); // on the pane alone
        add_light({.kind = LightKind::directional, .colour = {1, 0.9f, 0.8f}, .intensity = 1}, {}, {0.4, -0.3, -1});
        add_light({.colour = {1, 0.2f, 0.2f}, .intensity = 30, .range = 20}, {-3, 2, 4});
        add_light({.kind = LightKind::spot, .colour = {0.2f, 1, 0.2f}, .intensity = 60}, {4, 3, 4.5}, {-0.6, -0.5, -1});
        // In front of the sphere, behind the pane: lights what is opaque.
        add_light({.colour = {0.3f, 0.3f, 1}, .intensity = 5}, {0, 0, 1});
    }
};

struct Lit {
    Shading shading = Shading::ggx;
    bool shadows = false;
    double occlusion = 0;
    const char* shader = "";
};

TEST(TransparentLight, APaneIsLitLikeAnOpaqueOne) {
    for (const Lit& lit : {Lit{}, Lit{.shading = Shading::phong}, Lit{.shadows = true}, Lit{.occlusion = 2},
                           Lit{.shadows = true, .occlusion = 1, .shader = "skin"}, Lit{.shader = "layered"}}) {
        ReferenceForm form = in_layers;
        form.shading = lit.shading;
        form.shadows = lit.shadows;
        form.specular_antialiasing = true;
        form.transparent_shadows = Shadows::none;
        form.occlusion_radius = lit.occlusion;
        // Where a bump turns to light from behind, the opaque pane is in its own way.
        const bool bumps = !lit.shadows && lit.occlusion == 0;
        const Room with(true, AlphaMode::blend, bumps, lit.shader), without(false),
            opaque(true, AlphaMode::opaque, bumps, lit.shader);
        const auto layered = in_metres(with, form), behind = in_metres(without, form), solid = in_metres(opaque, form);
        size_t on_pane = 0;
        for (size_t i = 0; i < layered.linear.pixels.size(); ++i) {
            glm::dvec3 wanted(behind.linear.pixels[i]);
            if (layered.layer_count[i] == 1) {
                const double alpha = 0.4f;
                wanted = alpha * glm::dvec3(solid.linear.pixels[i]) + (1 - alpha) * wanted;
                EXPECT_EQ(layered.layers[on_pane].depth, solid.depth[i]);
                EXPECT_EQ(layered.layers[on_pane].normal, solid.normal[i]);
                ++on_pane;
            }
            expect_colour(layered.linear.pixels[i], wanted, std::to_string(i));
        }
        EXPECT_EQ(on_pane, layered.layers.size());
        EXPECT_GT(on_pane, 100u);
        // All else is of what is opaque.
        EXPECT_EQ(layered.depth, behind.depth);
        EXPECT_EQ(layered.instance, behind.instance);
        EXPECT_EQ(layered.normal, behind.normal);
        EXPECT_EQ(layered.shadow_mask, behind.shadow_mask);
    }
}

TEST(TransparentLight, DrawnOpaqueThePictureIsThatOfAnOpaqueMaterial) {
    for (const uint32_t samples : {1u, 4u}) {
        ReferenceForm form{.shadows = true, .specular_antialiasing = true, .samples = {.count = samples}};
        const Room blend(true), opaque(true, AlphaMode::opaque);
        const auto got = in_metres(blend, form), wanted = in_metres(opaque, form);
        EXPECT_TRUE(got.linear.pixels == wanted.linear.pixels);
        EXPECT_EQ(got.left_out(), wanted.left_out());
        EXPECT_EQ(got.edge, wanted.edge);
        EXPECT_TRUE(got.layers.empty() && got.layer_count.empty());
        form.transparency = Transparency::layers;
        EXPECT_FALSE(in_metres(blend, form).linear.pixels == wanted.linear.pixels);
        EXPECT_TRUE(in_metres(opaque, form).linear.pixels == wanted.linear.pixels);
    }
}

/// A wall that the camera sees, under light from behind the camera, where panes stand.
struct Dimmed : TestWorld {
    explicit Dimmed(const std::vector<float>& alphas) {
        add_material({.base_colour = {0.5f, 0.6f, 0.7f, 1}, .metallic = 0});
        add(square(30));
        for (size_t i = 0; i < alphas.size(); ++i) {
            add_material(blended({1, 1, 1}, alphas[i]));
            add(square(8), at_height(6 + static_cast<double>(i)));
        }
        add_light({.kind = LightKind::directional, .intensity = 2}, {}, {0, 0, -1});
    }
};

TEST(TransparentShadows, AreAsDeepAsTheirLayersTogether) {
    const std::vector<float> alphas{0.5f, 0.2f, 0.9f};
    for (const auto& [shadows, through] :
         {std::pair(Shadows::opaque, 0.0), {Shadows::filtered, 0.5 * 0.8 * 0.1}, {Shadows::none, 1.0}}) {
        ReferenceForm form = in_layers;
        form.shadows = true;
        form.transparent_shadows = shadows;
        const Dimmed with(alphas), without({});
        const auto dimmed = in_metres(with, form), bright = in_metres(without, form);
        EXPECT_TRUE(dimmed.layers.empty());
        for (uint32_t y = 0; y < rows; ++y)
            for (uint32_t x = 0; x < columns; ++x) {
                const bool under = x >= 4 && x < 20; // the panes' 16 metres
                const size_t i = size_t(y) * columns + x;
                expect_colour(dimmed.linear.pixels[i], (under ? through : 1.0) * glm::dvec3(bright.linear.pixels[i]),
                              std::to_string(x));
                EXPECT_EQ(dimmed.shadow_mask[i] != 0, under && shadows != Shadows::none);
            }
        // Beside the panes' two upright edges.
        const std::vector<uint8_t> out = dimmed.left_out();
        for (uint32_t x = 0; x < columns; ++x)
            EXPECT_EQ(out[8 * columns + x] != 0,
                      shadows != Shadows::none && ((x >= 3 && x <= 4) || (x >= 19 && x <= 20)))
                << x;
    }
}

TEST(TransparentShadows, FollowTheTexture) {
    TestWorld test;
    test.add_material({.metallic = 0});
    test.add(square(30));
    Material pane = blended({1, 1, 1}, 1);
    pane.base_colour_texture.image = test.add_image(2, 1, {0, 0, 0, 0, 0, 0, 0, 255});
    test.add_material(pane);
    test.add(square(12), at_height(6));
    test.add_light({.kind = LightKind::directional, .intensity = 2}, {}, {0, 0, -1});
    ReferenceForm form = in_layers;
    form.shadows = true;
    form.transparent_shadows = Shadows::filtered;
    const Image picture = in_metres(test, form).linear;
    // Texels' centres are 6 m left and right of the middle, between them alpha rises evenly.
    for (uint32_t x = 7; x < 17; ++x)
        EXPECT_NEAR(picture.at(x, 8).g / picture.at(6, 8).g, (1 - (x + 0.5 - 6) / 12) / (1 - 0.5 / 12), 1e-5) << x;
}

TEST(TransparentShadows, AnOpaqueSurfaceEndsAllLight) {
    Dimmed test({0.5f});
    test.add_material({});
    test.add(square(8), at_height(9));
    ReferenceForm form = in_layers;
    form.shadows = true;
    form.transparent_shadows = Shadows::filtered;
    EXPECT_EQ(in_metres(test, form).linear.at(12, 8), glm::vec3(0));
}

} // namespace
} // namespace prelight
