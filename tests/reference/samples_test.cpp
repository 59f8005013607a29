// Where the samples of a pixel are, what they cover, and what their mean is.
#include "sampled.hpp"
#include <gmock/gmock.h>
#include <prelight/error.hpp>
#include <reference/lens.hpp>

namespace prelight {
namespace {

constexpr ProjectionKind kinds[] = {ProjectionKind::perspective, ProjectionKind::orthographic};
// Vulkan 1.3, "Multisampling": standard sample locations.
const std::vector<glm::dvec2> standard_four{{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
const std::vector<glm::dvec2> standard_two{{0.75, 0.75}, {0.25, 0.25}};

/// White where light does not matter.
struct White : TestWorld {
    White() { add_material({.unlit = true}); }
};

TEST(Samples, LieWhereVulkanSays) {
    const auto places = [](uint32_t count) {
        const auto all = reference::sample_positions(count);
        return std::vector(all.begin(), all.end());
    };
    EXPECT_EQ(places(4), standard_four);
    EXPECT_EQ(places(2), standard_two);
    EXPECT_EQ(places(1), std::vector{glm::dvec2(0.5)});
    // A patch of a fiftieth of a pixel at each of them is seen by that sample alone.
    for (const auto& [count, table] : {std::pair(4u, standard_four), std::pair(2u, standard_two)})
        for (size_t i = 0; i < table.size(); ++i) {
            White test;
            test.add(square(0.01f),
                     glm::translate(glm::dmat4(1), glm::dvec3(at_pixel(5 + table[i].x, 3 + table[i].y))));
            for (const ProjectionKind kind : kinds) {
                const auto picture = sampled(test, metre_camera(kind), {.count = count});
                const size_t pixel = 3 * columns + 5;
                for (size_t s = 0; s < picture.sample_colours.size(); ++s)
                    EXPECT_EQ(picture.sample_colours[s], glm::vec3(s == pixel * count + i ? 1 : 0)) << s;
                EXPECT_EQ(picture.linear.pixels[pixel], glm::vec3(1.0f / static_cast<float>(count)));
            }
        }
}

TEST(Samples, OfWhichThereIsOneHaveNoForm) {
    TestWorld test;
    test.add_material({.roughness = 0.4f});
    test.add(sphere(16), glm::scale(glm::dmat4(1), glm::dvec3(6)));
    test.add_light({.intensity = 100}, {4, 3, 9});
    const PlacedCamera camera = metre_camera(ProjectionKind::perspective);
    const auto plain = render_reference(test.world, camera, columns, rows, 0, {});
    EXPECT_EQ(plain.samples, 1u);
    EXPECT_TRUE(plain.sample_colours.empty() && plain.edge.empty() && plain.doubts.empty());
    for (ReferenceSamples samples : every_form) {
        samples.count = 1;
        const auto picture = sampled(test, camera, samples);
        EXPECT_TRUE(picture.linear.pixels == plain.linear.pixels);
        EXPECT_TRUE(picture.left_out() == plain.left_out());
    }
    EXPECT_TRUE(plain.display(Tonemap::aces).pixels == tonemap(plain.linear, Tonemap::aces).pixels);
}

TEST(Samples, AreOneTwoOrFour) {
    const White test;
    const PlacedCamera camera = metre_camera(ProjectionKind::perspective);
    for (const uint32_t count : {0u, 3u, 8u, 16u})
        EXPECT_THAT([&] { sampled(test, camera, {.count = count}); },
                    testing::ThrowsMessage<Error>(testing::HasSubstr("not one of 1, 2, 4")));
}

TEST(Samples, CoverageOfASlopingEdgeIsThatOfItsSamples) {
    // Everything to the right of a line from (7.3, 0) to (13.1, 16), in pixels.
    const double top = 7.3, bottom = 13.1;
    White test;
    const double slope = (bottom - top) / rows;
    test.add(triangle(at_pixel(top - 100 * slope, -100), at_pixel(top + 200 * slope, 200), at_pixel(900, 50)));
    for (const auto& [count, table] : {std::pair(4u, standard_four), std::pair(2u, standard_two)})
        for (const ProjectionKind kind : kinds) {
            const auto picture = sampled(test, metre_camera(kind), {.count = count});
            uint32_t partial = 0;
            for (uint32_t y = 0; y < rows; ++y)
                for (uint32_t x = 0; x < columns; ++x) {
                    uint32_t covered = 0;
                    for (const glm::dvec2& place : table)
                        covered += x + place.x > top + slope * (y + place.y);
                    const glm::vec3 share(static_cast<float>(covered) / static_cast<float>(count));
                    EXPECT_EQ(picture.linear.at(x, y), share) << x << ", " << y;
                    EXPECT_EQ(picture.edge[y * columns + x], covered % count != 0);
                    partial += covered % count != 0;
                }
            EXPECT_GE(partial, rows / 4);
        }
}

TEST(Samples, AQuarterOfAPixelIsOneSample) {
    // An upright edge and a level one, moved by quarters: the four samples lie in four columns and four rows.
    for (const bool upright : {true, false})
        for (int quarters = 0; quarters <= 8; ++quarters) {
            White test;
            const double edge = 6 + quarters / 4.0;
            const glm::vec3 a = upright ? at_pixel(edge, -500) : at_pixel(-500, edge);
            const glm::vec3 b = upright ? at_pixel(edge, 500) : at_pixel(500, edge);
            test.add(triangle(a, b, at_pixel(900, 900)));
            const auto picture = sampled(test, metre_camera(ProjectionKind::orthographic), {.count = 4});
            for (int pixel = 6; pixel < 8; ++pixel) {
                const float covered = static_cast<float>(std::clamp(4 * (pixel - 5) - quarters, 0, 4)) / 4;
                const auto at = static_cast<uint32_t>(pixel);
                EXPECT_EQ(picture.linear.at(upright ? at : 9, upright ? 9 : at).r, covered) << quarters;
            }
        }
}

TEST(Samples, OfAWallUnderEvenLightAreAsOne) {
    TestWorld test;
    test.add_material({.base_colour = {0.8f, 0.5f, 0.2f, 1}, .metallic = 0.3f, .roughness = 0.4f});
    test.add(wall_triangle());
    test.world.ambient = {0.3f, 0.2f, 0.1f};
    for (const ProjectionKind kind : kinds) {
        // Seen in parallel, a directional light gives the same everywhere.
        test.world.lights.clear();
        if (kind == ProjectionKind::orthographic)
            test.add_light({.kind = LightKind::directional}, {}, {0.3, 0.2, -1});
        const PlacedCamera camera = metre_camera(kind);
        const auto one = render_reference(test.world, camera, columns, rows, 0, {});
        for (const ReferenceSamples& samples : every_form) {
            const auto picture = sampled(test, camera, samples);
            for (size_t i = 0; i < one.linear.pixels.size(); ++i)
                for (int channel = 0; channel < 3; ++channel)
                    EXPECT_NEAR(picture.linear.pixels[i][channel], one.linear.pixels[i][channel], 1e-6);
            EXPECT_THAT(picture.edge, testing::Each(0));
            EXPECT_THAT(picture.doubts, testing::Each(0));
        }
    }
}

TEST(Samples, AreToneMappedBeforeTheyMeet) {
    // Half of the pixels 6 is eight times as bright as the display can be.
    TestWorld test;
    test.add_material({.base_colour = {8, 8, 8, 1}, .unlit = true});
    test.add(triangle(at_pixel(6.5, -500), at_pixel(6.5, 500), at_pixel(900, 0)));
    const auto picture = sampled(test, metre_camera(ProjectionKind::orthographic), {.count = 4});
    EXPECT_EQ(picture.linear.at(6, 3), glm::vec3(4));
    EXPECT_FLOAT_EQ(picture.display(Tonemap::none).at(6, 3).g, srgb_encode(0.5f));
    EXPECT_FLOAT_EQ(picture.display(Tonemap::aces).at(6, 3).g,
                    srgb_encode(0.5f * display_light(glm::vec3(8), Tonemap::aces).g));
    EXPECT_EQ(picture.display(Tonemap::none).at(9, 3).g, srgb_encode(1));
}

} // namespace
} // namespace prelight
