// How far the split sum and nine harmonics lie from the integrals that they stand for.
#include "worlds.hpp"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <reference/environment.hpp>

namespace prelight {
namespace {

constexpr double pi = 3.14159265358979323846;

glm::dvec3 direction_of(double u, double v) {
    const double round = (u - 0.5) * 2 * pi, polar = v * pi;
    return {std::sin(round) * std::sin(polar), std::cos(polar), -std::cos(round) * std::sin(polar)};
}

Environment sky_of(const std::function<glm::dvec3(glm::dvec3)>& radiance, uint32_t width = 256) {
    Environment sky{.name = "sky", .image = Image(width, width / 2)};
    for (uint32_t y = 0; y < width / 2; ++y)
        for (uint32_t x = 0; x < width; ++x)
            sky.image.at(x, y) = glm::vec3(radiance(direction_of((x + 0.5) / width, (y + 0.5) / (width / 2))));
    return sky;
}

/// A bright window in a sky over a dark floor.
glm::dvec3 window_sky(glm::dvec3 d) {
    const double up = 0.5 + 0.5 * std::tanh(4 * d.y);
    const double window = std::exp((glm::dot(d, glm::normalize(glm::dvec3(0.5, 0.5, 1))) - 1) / 0.03);
    return glm::mix(glm::dvec3(0.2, 0.17, 0.13), glm::dvec3(0.3, 0.5, 0.9), up) +
           8.0 * window * glm::dvec3(1, 0.9, 0.7);
}

/// ∫ f dω over the sphere around the z axis `up`, by a midpoint rule of 1.4°.
glm::dvec3 integral(const std::function<glm::dvec3(glm::dvec3)>& f) {
    glm::dvec3 sum(0);
    constexpr int rows = 128, columns = 256;
    for (int y = 0; y < rows; ++y) {
        const double area = 2 * pi / columns * (std::cos(pi * y / rows) - std::cos(pi * (y + 1) / rows));
        for (int x = 0; x < columns; ++x)
            sum += area * f(direction_of((x + 0.5) / columns, (y + 0.5) / rows));
    }
    return sum;
}

/// What a metal really sends on of the environment: glTF 2.0's D, V and F over all directions.
glm::dvec3 true_reflection(const reference::EnvironmentLight& light, glm::dvec3 n, glm::dvec3 v, double roughness,
                           glm::dvec3 f0) {
    const double a2 = std::pow(roughness, 4), nv = glm::dot(n, v);
    return integral([&](glm::dvec3 l) {
        const double nl = glm::dot(n, l);
        if (nl <= 0)
            return glm::dvec3(0);
        const glm::dvec3 h = glm::normalize(l + v);
        const double nh = glm::dot(n, h), spread = nh * nh * (a2 - 1) + 1;
        const double d = a2 / (pi * spread * spread);
        const double vis = 1 / ((nl + std::sqrt(a2 + (1 - a2) * nl * nl)) * (nv + std::sqrt(a2 + (1 - a2) * nv * nv)));
        return nl * d * vis * (f0 + (1.0 - f0) * std::pow(1 - glm::dot(v, h), 5)) * light.radiance(l);
    });
}

/// Root mean square of what the split sum is off by, over a sphere seen from the front, in parts of the mean.
double split_sum_error(double roughness) {
    const Environment sky = sky_of(window_sky);
    const reference::EnvironmentLight light(&sky);
    const glm::dvec3 f0(1, 0.77, 0.34), v(0, 0, 1);
    double off = 0, whole = 0;
    int count = 0;
    for (int y = -3; y <= 3; ++y)
        for (int x = -3; x <= 3; ++x) {
            const glm::dvec2 p = glm::dvec2(x, y) / 3.4;
            if (glm::dot(p, p) > 0.95)
                continue;
            const glm::dvec3 n(p, std::sqrt(1 - glm::dot(p, p)));
            const glm::dvec3 is = true_reflection(light, n, v, roughness, f0);
            const glm::dvec3 split = reference::environment_share(f0, 1, roughness, n.z) *
                                     light.mirrored(reference::mirror_direction(n, v, roughness), roughness);
            off += glm::dot(is - split, is - split) / 3;
            whole += (is.r + is.g + is.b) / 3;
            ++count;
        }
    return std::sqrt(off / count) / (whole / count);
}

TEST(SplitSum, LiesThisFarFromTheTrueReflection) {
    // The viewer of a prefiltered lobe looks along the normal: a lobe that is seen askew is really longer than wide.
    const std::pair<double, double> bounds[] = {{0.25, 0.03}, {0.5, 0.12}, {0.75, 0.19}, {1.0, 0.08}};
    for (const auto& [roughness, bound] : bounds) {
        const double error = split_sum_error(roughness);
        std::printf("    roughness %.2f: %.3f of the mean\n", roughness, error);
        EXPECT_LT(error, bound) << roughness;
        EXPECT_GT(error, 1e-4) << "an approximation that is exact is not what it says";
    }
}

TEST(SplitSum, OfOneRadianceIsTheDirectionalReflectance) {
    const Environment white = sky_of([](glm::dvec3) { return glm::dvec3(1); }, 64);
    const reference::EnvironmentLight light(&white);
    for (const double roughness : {0.3, 0.6, 1.0})
        for (const double nv : {0.2, 0.6, 1.0}) {
            const glm::dvec3 n(0, 0, 1), v(std::sqrt(1 - nv * nv), 0, nv);
            for (const double f0 : {0.04, 1.0}) {
                const double is = true_reflection(light, n, v, roughness, glm::dvec3(f0)).r;
                EXPECT_NEAR(reference::environment_share(glm::dvec3(f0), 1, roughness, nv).r, is, 0.06)
                    << roughness << " " << nv << " " << f0;
            }
            EXPECT_NEAR(light.mirrored(n, roughness).r, 1, 1e-9);
        }
}

TEST(Irradiance, OfNineHarmonicsLiesThisFarFromTheCosineIntegral) {
    const Environment sky = sky_of(window_sky);
    const reference::EnvironmentLight light(&sky);
    double worst = 0, mean = 0;
    constexpr int normals = 40;
    for (int i = 0; i < normals; ++i) { // a spiral over the sphere
        const double z = 1 - (2 * i + 1.0) / normals, round = 2.399963 * i;
        const glm::dvec3 n(std::sqrt(1 - z * z) * std::cos(round), z, std::sqrt(1 - z * z) * std::sin(round));
        const glm::dvec3 is =
            integral([&](glm::dvec3 l) { return std::max(glm::dot(n, l), 0.0) * light.radiance(l); }) / pi;
        const double off = glm::length(light.lambert(n) - is) / glm::length(is);
        worst = std::max(worst, off);
        mean += off / normals;
    }
    std::printf("    harmonics: %.3f off in the mean, %.3f at most\n", mean, worst);
    EXPECT_LT(mean, 0.03);
    EXPECT_LT(worst, 0.09); // Ramamoorthi and Hanrahan's own bound
}

TEST(Irradiance, IsExactForWhatTheHarmonicsHold) {
    const Environment sky =
        sky_of([](glm::dvec3 d) { return glm::dvec3(1 + 0.5 * d.y, 1 + d.x * d.z, 1 + 0.4 * (3 * d.z * d.z - 1)); });
    const reference::EnvironmentLight light(&sky);
    for (const glm::dvec3& n :
         {glm::dvec3(0, 1, 0), glm::normalize(glm::dvec3(1, 0.5, -2)), glm::normalize(glm::dvec3(-1, 1, 1))}) {
        const glm::dvec3 got = light.lambert(n);
        EXPECT_NEAR(got.r, 1 + 0.5 * n.y * 2 / 3, 1e-3);
        EXPECT_NEAR(got.g, 1 + n.x * n.z / 4, 1e-3);
        EXPECT_NEAR(got.b, 1 + 0.4 * (3 * n.z * n.z - 1) / 4, 1e-3);
    }
}

/// The cosine integral over the map itself: what a white wall really sends on.
double wall_under(const reference::EnvironmentLight& light, glm::dvec3 n) {
    return integral([&](glm::dvec3 l) { return std::max(glm::dot(n, l), 0.0) * light.radiance(l); }).g / pi;
}

TEST(Studio, IsGreyAndHasLampsBrighterThanWhite) {
    const Environment studio = make_environment("studio");
    float brightest = 0, darkest = 1;
    for (const Image* map : {&studio.image, &studio.backdrop}) {
        ASSERT_EQ(map->width, 2 * map->height);
        for (const glm::vec3& p : map->pixels) {
            ASSERT_EQ(p.r, p.g);
            ASSERT_EQ(p.g, p.b);
            ASSERT_GT(p.r, 0.1f);
            brightest = std::max(brightest, p.r);
            darkest = std::min(darkest, p.r);
        }
    }
    EXPECT_GT(brightest, 5) << "of high dynamic range";
    EXPECT_LT(darkest, 0.25f) << "metals have something dark to mirror too";
    EXPECT_TRUE(studio.image.pixels == make_environment("studio").image.pixels);
    EXPECT_THROW(make_environment("meadow"), UsageError);
}

TEST(Studio, ShowsWhiteAsWhiteFromTheFrontAndLeavesFormFromTheOtherSides) {
    const Environment studio = make_environment("studio");
    const reference::EnvironmentLight light(&studio);
    const auto from = [&](double azimuth, double elevation) {
        const double a = azimuth * pi / 180, e = elevation * pi / 180;
        return wall_under(light, {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)});
    };
    const double front = from(25, 15), above = from(0, 90), below = from(0, -90);
    std::printf("    front %.3f, left %.3f, right %.3f, behind %.3f, above %.3f, below %.3f\n", front, from(-60, 15),
                from(90, 0), from(-155, 0), above, below);
    const auto shine = [&](double azimuth, double elevation) {
        const double a = azimuth * pi / 180, e = elevation * pi / 180;
        return light.radiance({std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)}).g;
    };
    EXPECT_GT(shine(-40, 34), 5) << "the key, from the upper left of the camera";
    EXPECT_LT(shine(40, 34), 1);
    EXPECT_GT(front, 0.8);
    EXPECT_LT(front, 1);
    for (int azimuth = -180; azimuth < 180; azimuth += 60)
        for (int elevation = -90; elevation <= 90; elevation += 45) {
            EXPECT_LT(from(azimuth, elevation), 1.5) << azimuth << " " << elevation;
            EXPECT_GT(from(azimuth, elevation), 0.2) << azimuth << " " << elevation;
        }
    EXPECT_GT(above, 1.8 * below) << "light comes from above";
}

TEST(Studio, ItsHarmonicsLieWithinAFewPercentOfTheIntegral) {
    const Environment studio = make_environment("studio");
    const reference::EnvironmentLight light(&studio);
    for (const glm::dvec3& n : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(-1, 0.5, 1)),
                                glm::normalize(glm::dvec3(1, -0.3, -1))})
        EXPECT_NEAR(light.lambert(n).g / wall_under(light, n), 1, 0.06);
}

/// A backdrop is grey, light and soft: no step that an eye would find, nothing near white or black.
TEST(Backdrop, IsSoftAndNeutral) {
    const Image backdrop = soft_backdrop();
    for (uint32_t y = 0; y < backdrop.height; ++y)
        for (uint32_t x = 0; x < backdrop.width; ++x) {
            const glm::vec3 p = backdrop.at(x, y);
            EXPECT_EQ(p.r, p.b);
            EXPECT_GT(p.r, 0.1f);
            EXPECT_LT(p.r, 0.7f);
            if (y > 0) {
                EXPECT_LT(std::abs(srgb_encode(p.r) - srgb_encode(backdrop.at(x, y - 1).r)), 0.02f);
            }
        }
}

/// It is seen, and lights nothing.
TEST(Backdrop, StandsInFrontOfTheMap) {
    Environment sky = sky_of([](glm::dvec3) { return glm::dvec3(1, 2, 3); }, 64);
    sky.backdrop = sky_of([](glm::dvec3 d) { return glm::dvec3(0.5 + 0.25 * d.y); }, 256).image;
    sky.intensity = 0.5f;
    sky.rotation = 1;
    const reference::EnvironmentLight light(&sky);
    for (const glm::dvec3& d : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1), glm::normalize(glm::dvec3(1, -1, 1))}) {
        EXPECT_NEAR(light.background(d).g, 0.5 * (0.5 + 0.25 * d.y), 1e-3);
        EXPECT_NEAR(light.radiance(d).g, 1, 1e-6);
        EXPECT_NEAR(light.lambert(d).b, 1.5, 1e-3);
    }
}

TEST(Mirrored, DoesNotDependOnWhereTheLampIsHit) {
    // A lamp of one texel: what a rough mirror sends on of it must be its light, not whether a sample met it.
    Environment sky{.name = "lamp", .image = Image(512, 256)};
    sky.image.at(300, 128) = glm::vec3(1000);
    const reference::EnvironmentLight light(&sky);
    const glm::dvec3 lamp = direction_of(300.5 / 512, 128.5 / 256);
    const glm::dvec3 across = glm::normalize(glm::cross(lamp, glm::dvec3(0, 1, 0)));
    double low = 1e9, high = 0;
    for (int i = 0; i < 20; ++i) {
        const double angle = 0.002 * i;
        const double shown = light.mirrored(std::cos(angle) * lamp + std::sin(angle) * across, 0.7).r;
        low = std::min(low, shown);
        high = std::max(high, shown);
    }
    EXPECT_GT(low, 0.7 * high);
}

} // namespace
} // namespace prelight
