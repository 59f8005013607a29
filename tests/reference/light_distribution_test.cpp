// Which way pictures lie, how levels and profiles are mixed: by hand.
#include "worlds.hpp"
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <prelight/light_distribution.hpp>
#include <reference/light_distribution.hpp>

namespace prelight::reference {
namespace {

constexpr double pi = std::numbers::pi;

double linear(double e) { return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4); }
uint8_t code(double linear) {
    return uint8_t(
        std::lround(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055)));
}

/// Each channel is brightest towards one axis.
glm::dvec3 colour_of(glm::dvec3 d) { return 0.5 + 0.4 * glm::normalize(d); }

template <class Direction>
uint32_t add_picture(TestWorld& test, uint32_t width, uint32_t height, Direction direction) {
    std::vector<uint8_t> rgba;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::dvec3 c = colour_of(direction((x + 0.5) / width, (y + 0.5) / height));
            rgba.insert(rgba.end(), {code(c.r), code(c.g), code(c.b), 255});
        }
    return test.add_image(width, height, rgba);
}

/// Directions all around, in the light's own space.
std::vector<glm::dvec3> all_around() {
    std::vector<glm::dvec3> out;
    for (int i = 0; i < 500; ++i) { // a spiral
        const double y = 1 - (i + 0.5) / 250, angle = 2.399963 * i, r = std::sqrt(1 - y * y);
        out.push_back({r * std::cos(angle), y, r * std::sin(angle)});
    }
    return out;
}

LightDistribution made(const TestWorld& test, const PlacedLight& light) {
    LightDistribution::Pictures pictures;
    return LightDistribution(test.world, light, pictures);
}

TEST(LightDistribution, AnEquirectangularPictureIsSeenFromTheLight) {
    TestWorld test;
    const uint32_t image = add_picture(test, 256, 128, [](double u, double v) {
        const double longitude = (u - 0.5) * 2 * pi, latitude = (0.5 - v) * pi; // the middle along −Z, right of it +X
        return glm::dvec3(std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                          -std::cos(longitude) * std::cos(latitude));
    });
    const LightDistribution light =
        made(test, {{.kind = LightKind::point, .cookie = image}, glm::dvec3(0), {0, 0, -1}, {0, 1, 0}});
    for (const glm::dvec3& d : all_around())
        EXPECT_LT(glm::distance(light.factor(d, 0), colour_of(d)), 0.012) << d.x << ' ' << d.y << ' ' << d.z;
}

TEST(LightDistribution, AStripOfSixIsACubeSeenFromItsMiddle) {
    TestWorld test;
    const uint32_t image = add_picture(test, 6 * 64, 64, [](double u, double v) {
        const int face = int(u * 6);
        const double right = 2 * (u * 6 - face) - 1, up = 1 - 2 * v;
        // As one who stands in it and turns his head: +X is right of −Z.
        const glm::dvec3 ahead[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        const glm::dvec3 over = face == 2   ? glm::dvec3(0, 0, 1)
                                : face == 3 ? glm::dvec3(0, 0, -1)
                                            : glm::dvec3(0, 1, 0);
        return ahead[face] + right * glm::cross(ahead[face], over) + up * over;
    });
    const LightDistribution light =
        made(test, {{.kind = LightKind::point, .cookie = image}, glm::dvec3(0), {0, 0, -1}, {0, 1, 0}});
    for (const glm::dvec3& d : all_around())
        EXPECT_LT(glm::distance(light.factor(d, 0), colour_of(d)), 0.015) << d.x << ' ' << d.y << ' ' << d.z;
    // No seam: on both sides of each edge and corner the same, on the small levels too.
    for (const double spread : {0.0, 0.2, 0.7})
        for (const glm::dvec3& edge :
             {glm::dvec3(1, 1, 0.3), {1, -1, 0.2}, {-1, 0.1, 1}, {0.4, 1, -1}, {-0.3, -1, -1}, {1, 0.5, -1}}) {
            const glm::dvec3 a = glm::normalize(edge * (1.0 + 1e-7 * glm::dvec3(1, 0, 0))),
                             b = glm::normalize(edge * (1.0 - 1e-7 * glm::dvec3(1, 0, 0)));
            EXPECT_LT(glm::distance(light.factor(a, spread), light.factor(b, spread)), spread > 0 ? 0.04 : 0.01)
                << edge.x << ' ' << edge.y << ' ' << edge.z;
        }
}

TEST(LightDistribution, ASpotsPictureFillsTheSquareAroundItsCone) {
    TestWorld test;
    const uint32_t image = test.add_image(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0});
    const double tangent = std::tan(0.5);
    // Looks down, +Y of its node is world −Z: as one who hangs from the ceiling with his head to the back.
    const LightDistribution light = made(
        test, {{.kind = LightKind::spot, .outer_cone = 0.5f, .cookie = image}, glm::dvec3(0), {0, -1, 0}, {0, 0, -1}});
    const auto at = [&](double right, double up) {
        return light.factor(glm::normalize(glm::dvec3(right * tangent, -1, -up * tangent)), 0);
    };
    EXPECT_LT(glm::distance(at(-0.6, 0.6), {1, 0, 0}), 1e-6);
    EXPECT_LT(glm::distance(at(0.6, 0.6), {0, 1, 0}), 1e-6);
    EXPECT_LT(glm::distance(at(-0.6, -0.6), {0, 0, 1}), 1e-6);
    EXPECT_LT(glm::distance(at(0.6, -0.6), {1, 1, 1}), 1e-6) << "alpha does not count";
    EXPECT_LT(glm::distance(at(0, 0.9), {0.5, 0.5, 0}), 1e-6) << "bilinear";
    EXPECT_LT(glm::distance(at(0.5, 0), {0.5, 1, 0.5}), 1e-6);
    EXPECT_EQ(light.factor({0, 1, 0}, 0), glm::dvec3(0)) << "nothing goes backwards";
}

TEST(LightDistribution, LevelsFollowTheAngleOfAPixel) {
    TestWorld test;
    std::vector<uint8_t> rgba;
    for (int i = 0; i < 64 * 64; ++i)
        rgba.insert(rgba.end(), 3, (i % 64 + i / 64) % 2 ? 255 : 0), rgba.push_back(255);
    const uint32_t image = test.add_image(64, 64, rgba);
    const LightDistribution light =
        made(test, {{.kind = LightKind::spot, .outer_cone = float(pi / 4), .cookie = image}, glm::dvec3(0)});
    const double texel = 2.0 / 64;                                                  // on the axis, as an angle
    const glm::dvec3 d = glm::normalize(glm::dvec3(0.5 * texel, -0.5 * texel, -1)); // the middle of a dark texel
    EXPECT_NEAR(light.factor(d, 0).r, 0, 1e-6);                                     // the cone is a float
    EXPECT_NEAR(light.factor(d, texel / 2).r, 0, 1e-6);
    EXPECT_NEAR(light.factor(d, texel * 1.41421356).r, 0.25, 1e-3) << "half way to level 1, which is grey";
    EXPECT_NEAR(light.factor(d, texel * 2).r, 0.5, 1e-3);
    EXPECT_NEAR(light.factor(d, 100).r, 0.5, 1e-9);
}

TEST(LightDistribution, LevelsOfAnySizeAreMeans) {
    TextureImage image{"odd", 5, 3, {}};
    for (int i = 0; i < 15; ++i)
        image.rgba.insert(image.rgba.end(), {uint8_t(i * 17), 0, 0, 255});
    const Pyramid pyramid(image, 0, 5);
    ASSERT_EQ(pyramid.levels.size(), 3u);
    EXPECT_EQ(pyramid.levels[1].width, 2);
    EXPECT_EQ(pyramid.levels[1].height, 1);
    double left = 0, all = 0;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) {
            const double value = linear((5 * y + x) * 17 / 255.0);
            all += value / 15;
            left += value * (x < 2 ? 1 : x == 2 ? 0.5 : 0) / 7.5;
        }
    EXPECT_NEAR(pyramid.levels[1].at(0, 0).r, left, 1e-12);
    EXPECT_NEAR(pyramid.levels[2].at(0, 0).r, all, 1e-12);
}

TEST(LightDistribution, AProfileIsMixedBetweenItsAngles) {
    TestWorld test;
    // Vertical 10, 30, 90; horizontal 0 and 90 of four alike quarters.
    const auto profile = std::make_shared<const LightProfile>(
        parse_profile("TILT=NONE\n1 1 1 3 2 1 2 0 0 0 1 1 0\n10 30 90 0 90\n80 40 10  20 0 0\n", "a"));
    const LightDistribution light = made(test, {{.kind = LightKind::point, .profile = profile}, glm::dvec3(0)});
    const auto at = [&](double off_axis, double around) { // degrees
        const double a = off_axis * pi / 180, b = around * pi / 180;
        const glm::dvec3 f = light.factor({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), -std::cos(a)}, 0.3);
        EXPECT_EQ(f.r, f.g);
        return f.r * 80;
    };
    EXPECT_NEAR(at(30, 0), 40, 1e-9);
    EXPECT_NEAR(at(20, 0), 60, 1e-9);
    EXPECT_NEAR(at(60, 0), 25, 1e-9);
    EXPECT_NEAR(at(30, 45), 20, 1e-9);
    EXPECT_NEAR(at(20, 90), 10, 1e-9);
    EXPECT_NEAR(at(20, 180), 60, 1e-9);
    EXPECT_NEAR(at(20, 315), 35, 1e-9);
    EXPECT_EQ(at(9.9, 0), 0) << "dark before the first angle";
    EXPECT_EQ(at(90.1, 0), 0) << "and past the last";
}

// The whole way through the reference: towards (x, y) of a wall comes what the picture has there.
TEST(LightDistribution, ThePictureIsOnTheWall) {
    TestWorld test;
    test.add_material({.metallic = 0, .roughness = 1});
    test.add(square(2));
    const uint32_t image = test.add_image(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
    test.add_light({.kind = LightKind::spot, .intensity = 50, .inner_cone = 0.5f, .outer_cone = 0.6f, .cookie = image},
                   {0, 0, 3});
    const ReferencePicture picture = render_reference(test.world, front_camera(5), 64, 64, 0, {});
    const auto colour = [&](uint32_t x, uint32_t y) {
        const glm::vec3 c = picture.linear.pixels[y * 64 + x];
        return c / std::max({c.r, c.g, c.b});
    };
    EXPECT_LT(glm::distance(colour(16, 16), {1, 0, 0}), 0.05f);
    EXPECT_LT(glm::distance(colour(47, 16), {0, 1, 0}), 0.05f);
    EXPECT_LT(glm::distance(colour(16, 47), {0, 0, 1}), 0.05f);
    EXPECT_LT(glm::distance(colour(47, 47), {1, 1, 1}), 0.05f);
}

} // namespace
} // namespace prelight::reference
