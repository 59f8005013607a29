// What the reference shows through transmissive surfaces, against what can be worked out by hand
// (docs/transmission.md).
#include "worlds.hpp"
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <prelight/material_shader.hpp>
#include <reference/behind.hpp>
#include <reference/lighting.hpp>
#include <reference/transmission.hpp>

namespace prelight {
namespace {

using reference::Behind;
using reference::Surface;

const ReferenceForm layered_form{.transparency = ReferenceForm::Transparency::layers};

Material shown_as(const char* name, glm::vec4 colour, AlphaMode mode = AlphaMode::opaque) {
    return {.name = name, .base_colour = colour, .alpha_mode = mode, .unlit = true};
}

/// It reflects nothing, unless `more` says so.
Material glass_of(glm::vec3 colour, float roughness = 0, const std::map<std::string, glm::vec4>& more = {}) {
    Material material{.name = "clear", .base_colour = {colour, 1}, .metallic = 0, .roughness = roughness};
    material.shader = find_material_shader("layered");
    material.parameters = more;
    material.parameters.emplace("transmission", glm::vec4(1));
    material.parameters.emplace("specular", glm::vec4(0));
    return material;
}

/// Stripes behind a pane that covers the whole picture, without any light.
struct StripedWindow : TestWorld {
    explicit StripedWindow(Material pane, glm::dmat4 turn = glm::dmat4(1)) {
        for (int i = -8; i < 8; ++i) {
            const float t = 0.5f + 0.05f * static_cast<float>(i);
            add_material(shown_as("stripe", {t, 1 - t, i % 2 ? 0.9f : 0.1f, 1}));
            add(square(0.25f), glm::scale(glm::translate(glm::dmat4(1), {0.5 * i + 0.25, 0, -2}), {1, 40, 1}));
        }
        add_material(std::move(pane));
        add(square(4), turn);
    }
    ReferencePicture picture(const ReferenceForm& form = layered_form) const {
        return render_reference(world, front_camera(5), 40, 30, 0, form);
    }
    Image without() {
        world.instances.back().visible = false;
        Image image = picture().linear;
        world.instances.back().visible = true;
        return image;
    }
};

void expect_tinted(const Image& is, const Image& behind, glm::dvec3 tint) {
    for (size_t i = 0; i < is.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(double(is.pixels[i][c]), tint[c] * double(behind.pixels[i][c]), 1e-6) << "pixel " << i;
}

TEST(ReferenceTransmission, AThinSmoothWallTintsEachPixelAndNoMore) {
    StripedWindow window(glass_of({0.9f, 0.5f, 0.25f}), glm::rotate(glm::dmat4(1), 0.4, {0, 1, 0}));
    expect_tinted(window.picture().linear, window.without(), {0.9, 0.5, 0.25});
}

TEST(ReferenceTransmission, WhatIsReflectedDoesNotComeThrough) {
    StripedWindow window(glass_of({1, 1, 1}, 0, {{"specular", glm::vec4(1)}, {"ior", glm::vec4(2)}}));
    const Image is = window.picture().linear, behind = window.without();
    const size_t middle = 15 * 40 + 20; // N·V is almost 1
    EXPECT_NEAR(is.pixels[middle].r, behind.pixels[middle].r * (1 - 1.0 / 9), 1e-4);
}

TEST(ReferenceTransmission, APartOfItLeavesTheRestToTheDiffuseLayer) {
    StripedWindow window(glass_of({0.8f, 0.8f, 0.8f}, 0, {{"transmission", glm::vec4(0.25f)}}));
    window.world.ambient = glm::vec3(0.5f);
    const Image is = window.picture().linear, behind = window.without();
    for (size_t i = 0; i < is.pixels.size(); ++i)
        ASSERT_NEAR(double(is.pixels[i].r), 0.8 * (0.25 * double(behind.pixels[i].r) + 0.75 * 0.5), 1e-6);
}

TEST(ReferenceTransmission, AMetalLetsNothingThrough) {
    Material metal = glass_of({0.5f, 0.5f, 0.5f});
    metal.metallic = 1;
    for (const glm::vec3& pixel : StripedWindow(metal).picture().linear.pixels)
        ASSERT_EQ(pixel, glm::vec3(0));
}

// A body that does not bend light shows what a thin wall shows, less what it absorbs on its way, which grows with the
// node's scale.
TEST(ReferenceTransmission, AVolumeAbsorbsByItsThicknessInTheWorld) {
    const std::map<std::string, glm::vec4> volume{{"ior", glm::vec4(1)},
                                                  {"thickness", glm::vec4(0.5f)},
                                                  {"attenuation_distance", glm::vec4(2)},
                                                  {"attenuation_colour", {0.25f, 0.5f, 1, 0}}};
    StripedWindow window(glass_of({1, 1, 1}, 0.8f, volume), glm::scale(glm::dmat4(1), glm::dvec3(2)));
    const double lengths = 0.5 * 2 / 2;
    expect_tinted(window.picture().linear, window.without(), {std::pow(0.25, lengths), std::pow(0.5, lengths), 1});
}

TEST(ReferenceTransmission, RefractionMovesWhatIsBehindAsSnellsLawSays) {
    Camera camera{.kind = ProjectionKind::orthographic};
    camera.ymag = 3;
    camera.zfar = 20;
    const PlacedCamera placed = look_at(camera, {0, 0, 5}, {0, 0, 0});
    const reference::Lens lens(placed, 120, 60);
    constexpr double angle = 0.7, ior = 1.5, thickness = 0.8;
    Surface surface;
    surface.position = {0.3, 0.2, -5};
    surface.view = {0, 0, 1};
    surface.normal = {std::sin(angle), 0, std::cos(angle)};
    surface.layers.ior = ior;
    surface.layers.thickness = thickness;
    const double moved = -thickness * std::sin(angle - std::asin(std::sin(angle) / ior)); // towards −normal
    const reference::LookBehind look = look_behind(surface, lens, {66.5, 28.5});
    EXPECT_NEAR(look.place.x - 66.5, moved * 60 / 6, 1e-9); // pixels a metre
    EXPECT_NEAR(look.place.y, 28.5, 1e-9);
    surface.layers.thickness = 0;
    EXPECT_EQ(look_behind(surface, lens, {66.5, 28.5}).place, glm::dvec2(66.5, 28.5));
}

TEST(ReferenceTransmission, BlurGrowsWithRoughnessAndWithTheIndex) {
    const PlacedCamera placed = front_camera(5);
    const reference::Lens lens(placed, 1023, 500);
    Surface surface;
    surface.view = surface.normal = {0, 0, 1};
    surface.position = {0, 0, -5};
    const auto level = [&](double roughness, double ior) {
        surface.layers.body_roughness = roughness;
        surface.layers.ior = ior;
        return look_behind(surface, lens, {0, 0}).level;
    };
    EXPECT_EQ(level(0, 1.5), 0);
    EXPECT_NEAR(level(1, 1.5), 10, 1e-12); // log2(1 + 1023)
    EXPECT_NEAR(level(0.5, 2.4), 5, 1e-12);
    EXPECT_NEAR(level(0.5, 1.25), 2.5, 1e-12); // half bent, half as rough
    EXPECT_EQ(level(0.5, 1), 0);
}

TEST(ReferenceBehind, LevelsAreMeansOfFourByFourTexels) {
    Image picture(16, 9);
    picture.at(4, 3) = glm::vec3(64, 6.4f, 0);
    const Behind behind(picture);
    EXPECT_NEAR(behind.at({4.5, 3.5}, 0).r, 64, 1e-12);
    EXPECT_NEAR(behind.at({5, 3.5}, 0).r, 32, 1e-12) << "linear between texels";
    // Texel 4 is the first of two that texel 2 stands for, and the one after those of texel 1; row 3 is the second of
    // row 1's.
    EXPECT_NEAR(behind.at({5, 3}, 1).r, 9, 1e-12);
    EXPECT_NEAR(behind.at({3, 3}, 1).g, 0.3, 1e-6);
    EXPECT_NEAR(behind.at({5, 5}, 1).r, 3, 1e-12);
    EXPECT_NEAR(behind.at({7, 3}, 1).r, 0, 1e-12);
    EXPECT_NEAR(behind.at({5, 3}, 0.5).r, 0.5 * (9 + 0.25 * 64), 1e-12) << "linear between levels";
    for (glm::vec3& pixel : picture.pixels)
        pixel = glm::vec3(0.3f);
    for (const double level : {0.0, 1.0, 2.5, 4.0, 99.0})
        EXPECT_NEAR(Behind(picture).at({15.9, -3}, level).r, 0.3, 1e-6);
}

TEST(ReferenceTransmission, TheNearestOneShowsOpaqueSurfacesAlone) {
    StripedWindow window(glass_of({0.5f, 1, 1}));
    window.add_material(glass_of({1, 0.25f, 1}));
    window.add(square(4), glm::translate(glm::dmat4(1), {0, 0, 0.5}));
    expect_tinted(window.picture().linear,
                  [&] {
                      for (size_t i = 16; i < 18; ++i)
                          window.world.instances[i].visible = false;
                      Image image = window.picture().linear;
                      for (size_t i = 16; i < 18; ++i)
                          window.world.instances[i].visible = true;
                      return image;
                  }(),
                  {1, 0.25, 1});
}

TEST(ReferenceTransmission, BlendedSurfacesBehindItAreHiddenAndThoseBeforeItLieOverIt) {
    StripedWindow window(glass_of({0.5f, 1, 1}));
    const Image alone = window.picture().linear;
    window.add_material(shown_as("film", {0.2f, 0.4f, 0.6f, 0.25f}, AlphaMode::blend));
    window.add(square(8), glm::translate(glm::dmat4(1), {0, 0, -1}));
    EXPECT_EQ(window.picture().linear.pixels, alone.pixels);
    window.world.instances.back().transform[3].z = 1;
    const ReferencePicture over = window.picture();
    for (size_t i = 0; i < alone.pixels.size(); ++i)
        ASSERT_NEAR(double(over.linear.pixels[i].g), 0.25 * 0.4 + 0.75 * double(alone.pixels[i].g), 1e-6);
    EXPECT_EQ(over.layer_count[0], 2u);
    EXPECT_EQ(over.layers[1].alpha, 1);
}

TEST(ReferenceTransmission, CoverageAndMasksAreAsOfOtherMaterials) {
    Material half = glass_of({0, 0, 0});
    half.base_colour.a = 0.25f;
    half.alpha_mode = AlphaMode::blend;
    StripedWindow blended(half);
    expect_tinted(blended.picture().linear, blended.without(), glm::dvec3(0.75));
    half.alpha_mode = AlphaMode::mask;
    StripedWindow masked(half);
    EXPECT_EQ(masked.picture().linear.pixels, masked.without().pixels);
}

TEST(ReferenceTransmission, ThrowsNoShadowUnlessItIsDrawnOpaque) {
    TestWorld test;
    test.add_material({.name = "wall", .metallic = 0, .roughness = 1});
    test.add(square(20), glm::translate(glm::dmat4(1), {0, 0, -2}));
    test.add_material(glass_of({1, 1, 1}));
    test.add(square(1), glm::translate(glm::dmat4(1), {3, 0, 0}));
    test.add_light({.kind = LightKind::point, .intensity = 30}, {6, 0, 2});
    ReferenceForm form = layered_form;
    form.shadows = true;
    const auto wall = [&] { return render_reference(test.world, front_camera(5), 9, 9, 0, form).linear.at(4, 4).r; };
    const float lit = wall();
    EXPECT_GT(lit, 0);
    form.transparent_shadows = ReferenceForm::TransparentShadows::filtered;
    EXPECT_EQ(wall(), lit);
    form.transparency = ReferenceForm::Transparency::opaque;
    EXPECT_EQ(wall(), 0);
}

// A lamp behind a surface is what its mirror image before it would be as a highlight.
TEST(ReferenceTransmission, LampsBehindItShineThroughAsHighlights) {
    Surface surface;
    surface.normal = {0, 0, 1};
    surface.view = glm::normalize(glm::dvec3(0.3, 0.1, 1));
    surface.roughness = 0.4;
    surface.layers.shows_behind = true;
    surface.layers.transmission = 1;
    reference::Incident before{.to_light = glm::normalize(glm::dvec3(0.2, -0.4, 0.7)), .radiance = glm::dvec3(2, 3, 4)};
    reference::Incident behind = before;
    behind.to_light.z = -before.to_light.z;
    reference::Lighting front({}, surface), back({}, surface);
    front.add(before);
    back.add(behind);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(back.sums().through[c], front.sums().specular[c], 1e-12);
        EXPECT_GT(back.sums().through[c], 0);
    }
    EXPECT_EQ(back.sums().specular, glm::dvec3(0));
    EXPECT_EQ(front.sums().through, glm::dvec3(0));
    surface.layers.shows_behind = false;
    EXPECT_FALSE(reference::Lighting({}, surface).is_lit_by(behind));
}

} // namespace
} // namespace prelight
