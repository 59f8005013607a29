#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <prelight/image.hpp>

namespace prelight {
namespace {

glm::vec3 mapped(glm::vec3 colour, Tonemap curve) {
    Image image(1, 1);
    image.at(0, 0) = colour;
    return tonemap(image, curve).at(0, 0);
}

void expect_near(glm::vec3 got, glm::vec3 want, float bound = 2e-6f) {
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(got[channel], want[channel], bound) << "channel " << channel;
}

glm::vec3 encoded(glm::vec3 linear) { return {srgb_encode(linear.r), srgb_encode(linear.g), srgb_encode(linear.b)}; }

TEST(Srgb, KnownValuesAndInverse) {
    // IEC 61966-2-1: 18 % grey and the end of the linear part.
    EXPECT_NEAR(srgb_encode(0.18f), 0.461356f, 1e-5f);
    EXPECT_NEAR(srgb_encode(0.0031308f), 0.04045f, 1e-5f);
    EXPECT_FLOAT_EQ(srgb_encode(2), 1);
    EXPECT_EQ(srgb_encode(-1), 0);
    for (int i = 0; i <= 255; ++i) {
        const float value = static_cast<float>(i) / 255;
        EXPECT_NEAR(srgb_encode(srgb_decode(value)), value, 2e-6f);
    }
}

TEST(Tonemap, NoneClampsAndEncodes) { expect_near(mapped({0.18f, 2, -1}, Tonemap::none), {0.461356f, 1, 0}, 1e-5f); }

TEST(Tonemap, PbrNeutralLeavesBaseColoursButF90) {
    // The specification: output = input − F90 where every channel lies in 0.08 … 0.8.
    expect_near(mapped({0.08f, 0.5f, 0.8f}, Tonemap::pbr_neutral), encoded({0.04f, 0.46f, 0.76f}));
    // Below, the offset is x − x²/(4·F90): for a grey of 0.04 that leaves 0.01.
    expect_near(mapped(glm::vec3(0.04f), Tonemap::pbr_neutral), encoded(glm::vec3(0.01f)));
    EXPECT_EQ(mapped(glm::vec3(0), Tonemap::pbr_neutral), glm::vec3(0));
}

TEST(Tonemap, PbrNeutralCompressesByHand) {
    // Grey 2: f = 0.04, p = 1.96, pn = 1 − 0.24²/(1.96 + 1 − 1.52) = 1 − 0.0576/1.44 = 0.96.
    expect_near(mapped(glm::vec3(2), Tonemap::pbr_neutral), encoded(glm::vec3(0.96f)));
    // (2, 0.5, 0.5): the same p and pn; g = 1/(0.15·1 + 1); 0.46·0.96/1.96·g + 0.96·(1 − g).
    const float g = 1 / 1.15f;
    const float low = 0.46f * 0.96f / 1.96f * g + 0.96f * (1 - g);
    expect_near(mapped({2, 0.5f, 0.5f}, Tonemap::pbr_neutral), encoded({0.96f, low, low}));
}

TEST(Tonemap, AcesByHand) {
    // x = 1: (2.51 + 0.03)/(2.43 + 0.59 + 0.14) = 2.54/3.16; x = 0.18 worked out likewise.
    const float grey = 0.18f * (2.51f * 0.18f + 0.03f) / (0.18f * (2.43f * 0.18f + 0.59f) + 0.14f);
    expect_near(mapped({1, 0.18f, 0}, Tonemap::aces), encoded({2.54f / 3.16f, grey, 0}));
}

TEST(Tonemap, RisesAndStaysFinite) {
    for (const Tonemap curve : {Tonemap::pbr_neutral, Tonemap::aces, Tonemap::none}) {
        float previous = 0;
        for (int step = 0; step <= 400; ++step) {
            const float grey = mapped(glm::vec3(static_cast<float>(step) * 0.01f), curve).g;
            EXPECT_GE(grey, previous) << "step " << step;
            previous = grey;
        }
        const float inf = std::numeric_limits<float>::infinity();
        const glm::vec3 extreme = mapped({inf, 1e30f, std::nanf("")}, curve);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_TRUE(std::isfinite(extreme[channel]));
            EXPECT_GE(extreme[channel], 0);
            EXPECT_LE(extreme[channel], 1);
        }
        EXPECT_GT(extreme.r, 0.9f);
    }
}

} // namespace
} // namespace prelight
