// Which pixels with layers a picture cannot judge, and what several samples make of them.
#include "panes.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace prelight {
namespace {

using Doubt = ReferencePicture::Doubt;

/// A wall with a pane of six metres before it.
struct Window : TestWorld {
    explicit Window(AlphaMode mode, double x = 0, bool lit = false) {
        add_material({.metallic = 0, .unlit = !lit});
        add(square(30));
        Material pane = blended({0, 0, 1}, 0.5f);
        pane.alpha_mode = mode;
        pane.unlit = !lit;
        add_material(pane);
        add(square(3), glm::translate(glm::dmat4(1), {x, 0, 2}));
    }
};

size_t sum_of(const std::vector<uint8_t>& bytes) { return std::accumulate(bytes.begin(), bytes.end(), size_t(0)); }

ReferenceForm of_samples(uint32_t count, ReferenceForm form = in_layers) {
    form.samples = {.count = count};
    return form;
}

TEST(TransparencyDoubts, EdgesOfLayersAreAsThoseOfOpaqueSurfaces) {
    for (const uint32_t samples : {1u, 4u})
        for (const double x : {0.0, 0.3, 0.375}) {
            const Window layered(AlphaMode::blend, x), opaque(AlphaMode::opaque, x);
            const auto got = in_metres(layered, of_samples(samples)), wanted = in_metres(opaque, of_samples(samples));
            EXPECT_EQ(got.left_out(), wanted.left_out()) << samples << " samples, " << x;
            EXPECT_EQ(got.doubts, wanted.doubts);
            EXPECT_EQ(got.edge, wanted.edge);
            // Round the pane of 6 by 6 pixels, two wide; of four samples where a sample lies on it.
            EXPECT_EQ(sum_of(got.left_out()) > 0, samples == 1 || x == 0.375) << samples << " samples, " << x;
        }
    EXPECT_EQ(sum_of(in_metres(Window(AlphaMode::blend)).left_out()), 64u - 16u);
}

TEST(TransparencyDoubts, WhereLayersChangeTheirOrder) {
    TestWorld test;
    for (const double angle : {-0.3, 0.3}) {
        test.add_material(blended({1, 0, 0}, 0.5f));
        test.add(square(40), glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 1, 0)));
    }
    const std::vector<uint8_t> out = in_metres(test).left_out();
    for (uint32_t x = 0; x < columns; ++x) // they cross in the middle
        EXPECT_EQ(out[8 * columns + x], x == columns / 2 - 1 || x == columns / 2) << x;
    EXPECT_EQ(sum_of(in_metres(test, of_samples(4)).left_out()), 0u); // at a pixel's border, far from samples
}

TEST(TransparencyDoubts, WhereALayerEndsInAnOpaqueSurface) {
    TestWorld test;
    test.add_material(unlit({1, 1, 1}));
    test.add(square(30));
    test.add_material(blended({1, 0, 0}, 0.5f));
    test.add(square(40), glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0, 1, 0))); // behind the wall on the right
    const std::vector<uint8_t> out = in_metres(test).left_out();
    EXPECT_EQ(sum_of(out), 2u * rows);
    EXPECT_EQ(out[8 * columns + columns / 2], 1);
}

TEST(TransparencyDoubts, ShadowsOnALayer) {
    for (const uint32_t samples : {1u, 4u}) {
        // The shadow of a small square behind the camera lies on the pane; what is opaque sees no light.
        Window test(AlphaMode::blend, 0, true);
        test.scene.materials[0].unlit = true;
        test.add_material({});
        test.add(square(1), at_height(8));
        test.add_light({.kind = LightKind::directional}, {}, {0, 0, -1});
        ReferenceForm form = of_samples(samples);
        form.shadows = true;
        form.transparent_shadows = ReferenceForm::TransparentShadows::none;
        const auto with = in_metres(test, form);
        test.world.lights[0].light.casts_shadow = false;
        const auto without = in_metres(test, form);
        EXPECT_EQ(sum_of(with.left_out()), sum_of(without.left_out()) + 16) << samples; // 4 by 4, all
        EXPECT_EQ(std::ranges::count_if(with.doubts, [](uint8_t all) { return all & Doubt::shadow; }),
                  samples == 1 ? 0 : 16);
    }
}

TEST(TransparencyDoubts, EachSampleHasItsLayers) {
    const double edge = 6.5; // of a pane, in pixels
    TestWorld test;
    test.add_material(unlit({1, 0.5f, 0}));
    test.add(wall_triangle());
    test.add_material(blended({0, 0, 1}, 0.25f));
    test.add(triangle(at_pixel(edge, -500), at_pixel(edge, 500), at_pixel(900, 0)), at_height(1));
    for (const SampleRate rate : {SampleRate::sample, SampleRate::fragment}) {
        ReferenceForm form = of_samples(4);
        form.samples.layers = rate;
        const auto picture = in_metres(test, form);
        const glm::dvec3 wall(1, 0.5, 0), both = laid_over(wall, {{{0, 0, 1}, 0.25f}});
        for (uint32_t x = 4; x < 9; ++x) {
            const size_t pixel = 8 * columns + x;
            glm::dvec3 mean(0);
            for (size_t s = 0; s < 4; ++s) {
                const double across = x + std::array{0.375, 0.875, 0.125, 0.625}[s];
                const glm::dvec3 wanted = across < edge ? wall : both;
                expect_colour(picture.sample_colours[pixel * 4 + s], wanted, std::to_string(across));
                mean += wanted / 4.0;
            }
            expect_colour(picture.linear.pixels[pixel], mean, "mean");
            EXPECT_EQ(picture.edge[pixel], x == 6);
        }
    }
}

TEST(TransparencyDoubts, OnceAFragmentIsUnderThePixelsCentre) {
    // Alpha rises from 0 to 1 from the left edge of the picture to its right one.
    TestWorld test;
    test.add_material(blended({1, 1, 1}, 1));
    Primitive pane = square(columns / 2);
    pane.colours = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}};
    test.add(pane);
    for (const SampleRate rate : {SampleRate::sample, SampleRate::fragment}) {
        ReferenceForm form = of_samples(4);
        form.samples.layers = rate;
        const auto picture = in_metres(test, form);
        for (uint32_t x = 0; x < columns; ++x)
            for (size_t s = 0; s < 4; ++s) {
                const double place = rate == SampleRate::fragment ? 0.5 : std::array{0.375, 0.875, 0.125, 0.625}[s];
                expect_colour(picture.sample_colours[(3 * columns + x) * 4 + s], glm::dvec3((x + place) / columns),
                              std::to_string(x));
            }
    }
}

} // namespace
} // namespace prelight
