// The reference's form of inferred lighting, by hand where it can be had.
#include "worlds.hpp"
#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <reference/reference_renderer.hpp>

namespace prelight {
namespace {

/// A wall before the camera, with a lamp beside it, in the model that is linear in the lights' sums.
struct Wall : TestWorld {
    Wall() {
        add_material({.name = "wall", .base_colour = {0.7f, 0.5f, 0.9f, 1}, .metallic = 0, .roughness = 0.6f});
        add(square(8));
        add_light({.kind = LightKind::point, .colour = {1, 0.8f, 0.6f}, .intensity = 8}, {0.7, 0.4, 1.2});
        world.ambient = glm::vec3(0.1f);
    }
    ReferencePicture picture(uint32_t width, uint32_t height, double scale) const {
        ReferenceForm form;
        form.shading = Shading::phong;
        form.transparency = ReferenceForm::Transparency::layers;
        form.inferred_scale = scale;
        return render_reference(world, front_camera(5), width, height, 0, form);
    }
};

TEST(InferredLight, AtFullSizeIsThatOfEachPixel) {
    Wall wall;
    wall.add(sphere(), glm::translate(glm::dmat4(1), {0.2, 0, 0.5}));
    EXPECT_EQ(wall.picture(48, 27, 1).linear.pixels, wall.picture(48, 27, 0).linear.pixels);
}

TEST(InferredLight, OnAPlaneItIsTheBilinearMeanOfTheSmallerPicture) {
    const Wall wall;
    for (const double scale : {0.75, 0.625, 0.5}) {
        const Image picture = wall.picture(64, 32, scale).linear;
        const auto width = static_cast<uint32_t>(64 * scale), height = static_cast<uint32_t>(32 * scale);
        const Image small = wall.picture(width, height, 0).linear;
        for (uint32_t y = 2; y < 30; ++y)
            for (uint32_t x = 2; x < 62; ++x) {
                const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) * scale - 0.5;
                const glm::uvec2 low(place);
                const glm::dvec2 f = place - glm::dvec2(low);
                const auto at = [&](uint32_t u, uint32_t v) {
                    return glm::dvec3(small.pixels[size_t(low.y + v) * width + low.x + u]);
                };
                const glm::dvec3 mean =
                    glm::mix(glm::mix(at(0, 0), at(1, 0), f.x), glm::mix(at(0, 1), at(1, 1), f.x), f.y);
                EXPECT_LT(glm::length(glm::dvec3(picture.pixels[size_t(y) * 64 + x]) - mean), 1e-5) << x << ", " << y;
            }
    }
}

// A ball before a wall: what is beside an edge has the light of its own side of it, wherever the edge runs.
TEST(InferredLight, NoLightComesOverAnEdge) {
    Wall wall;
    wall.world.lights.clear();
    wall.world.ambient = glm::vec3(0);
    wall.add_light({.kind = LightKind::point, .intensity = 8, .range = 1.5f}, {0, 0, 3.5}); // reaches the ball alone
    wall.add(sphere(), glm::scale(glm::translate(glm::dmat4(1), {0, 0, 2}), glm::dvec3(0.5)));
    const ReferencePicture half = wall.picture(96, 54, 0.5);
    size_t wall_pixels = 0, lit = 0;
    for (size_t i = 0; i < half.linear.pixels.size(); ++i) {
        wall_pixels += half.instance[i] == 0;
        if (half.instance[i] == 0) {
            EXPECT_EQ(half.linear.pixels[i], glm::vec3(0));
        } else {
            lit += half.linear.pixels[i].r > 0;
        }
    }
    EXPECT_GT(wall_pixels, 1000u);
    EXPECT_GT(lit, 100u);
}

// Of the four texels around a pixel the layer has one, and so have the two slots that nobody took; but those still show
// what is opaque. So the pixel has the mean of three.
TEST(InferredLight, UnderALayerTheRestOfTheFourTexelsCount) {
    Wall wall;
    const Image small = wall.picture(32, 18, 0).linear;
    wall.add_material({.name = "air", .base_colour = {1, 1, 1, 0}, .alpha_mode = AlphaMode::blend, .unlit = true});
    wall.add(square(1), glm::translate(glm::dmat4(1), {0, 0, 1})); // the first layer: slot 1
    const Image picture = wall.picture(64, 36, 0.5).linear;
    for (uint32_t y = 12; y < 24; ++y)
        for (uint32_t x = 26; x < 38; ++x) {
            const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) * 0.5 - 0.5;
            glm::dvec3 sum(0);
            double total = 0;
            for (uint32_t v = 0; v < 2; ++v)
                for (uint32_t u = 0; u < 2; ++u) {
                    const glm::uvec2 at = glm::uvec2(place) + glm::uvec2(u, v);
                    const glm::dvec2 near = 1.0 - glm::abs(place - glm::dvec2(at));
                    if (at.x % 2 == 1 && at.y % 2 == 0)
                        continue; // the layer's
                    sum += near.x * near.y * glm::dvec3(small.pixels[size_t(at.y) * 32 + at.x]);
                    total += near.x * near.y;
                }
            EXPECT_LT(glm::length(glm::dvec3(picture.pixels[size_t(y) * 64 + x]) - sum / total), 1e-5)
                << x << ", " << y;
        }
}

TEST(InferredLight, RefusesWhatCannotBe) {
    const Wall wall;
    EXPECT_THROW(wall.picture(8, 8, 2), Error);
    EXPECT_THROW(wall.picture(8, 8, 0.01), Error);
    ReferenceForm form;
    form.inferred_scale = 0.5;
    form.samples.count = 4;
    EXPECT_THROW(render_reference(wall.world, front_camera(5), 8, 8, 0, form), Error);
    const auto options = [](std::map<std::string, std::string> settings) {
        RenderOptions made;
        made.settings = std::move(settings);
        return made;
    };
    EXPECT_THROW(make_reference_renderer(options({{"inferred-scale", "1/2"}, {"model", "full"}})), UsageError);
    const auto made = make_reference_renderer(options({{"inferred-scale", "1/2"}}));
    EXPECT_EQ(made->stats().settings.at("model"), "weighted");
}

TEST(InferredLight, TheFormSaysTheScale) {
    const auto scale = [](const char* word) {
        return reference_form(Shading::ggx, {{"inferred-scale", word}}).inferred_scale;
    };
    EXPECT_EQ(scale("none"), 0);
    EXPECT_EQ(scale("1"), 1);
    EXPECT_EQ(scale("3/4"), 0.75);
    EXPECT_EQ(scale("5/8"), 0.625);
    EXPECT_EQ(scale("1/2"), 0.5);
    EXPECT_EQ(reference_form(Shading::ggx, {{"inferred-layers", "on"}}).transparency,
              ReferenceForm::Transparency::layers);
}

} // namespace
} // namespace prelight
