// --exposure auto, and what is lost of a picture.
#include <cmath>
#include <gtest/gtest.h>
#include <prelight/exposure.hpp>
#include <random>

namespace prelight {
namespace {

Image of(const std::vector<float>& values) {
    Image image(uint32_t(values.size()), 1);
    for (size_t i = 0; i < values.size(); ++i)
        image.pixels[i] = glm::vec3(values[i]);
    return image;
}

double ev_of(const std::vector<float>& values) {
    return auto_exposure(of(values), std::vector<bool>(values.size(), true)).value();
}

TEST(AutoExposure, BringsTheMeanOfLogarithmsToMiddleGrey) {
    EXPECT_EQ(ev_of(std::vector<float>(100, 0.18f)), 0);
    EXPECT_EQ(ev_of(std::vector<float>(100, 0.09f)), 1);
    EXPECT_EQ(ev_of(std::vector<float>(100, 18)), -6.6); // log2(0.01)
    std::vector<float> two(100, 0.18f * 2);
    std::fill_n(two.begin(), 50, 0.18f / 2);
    EXPECT_EQ(ev_of(two), 0);
    Image green(10, 1);
    for (glm::vec3& p : green.pixels)
        p = {0, 1, 0};
    EXPECT_EQ(auto_exposure(green, std::vector<bool>(10, true)), -2); // log2(0.18 / 0.7152)
}

TEST(AutoExposure, TwiceTheLightIsOneEvLess) {
    std::mt19937 random(3);
    std::lognormal_distribution<float> light(-1, 1.5);
    std::vector<float> values(5000);
    for (float& v : values)
        v = light(random);
    const double once = ev_of(values);
    for (const int stops : {-30, -7, 5, 8}) {
        std::vector<float> scaled = values;
        for (float& v : scaled)
            v = std::ldexp(v, stops);
        EXPECT_NEAR(ev_of(scaled), once - stops, 0.1001) << stops;
    }
}

TEST(AutoExposure, ANightWithBrightLampsStaysNight) {
    std::vector<float> night(1000, 0.01f);
    EXPECT_NEAR(ev_of(night), std::log2(18), 0.05) << "nothing bright: an underexposed picture";
    std::fill_n(night.begin(), 50, 2.0f);
    const double ev = ev_of(night);
    EXPECT_GT(ev, 0);
    EXPECT_LT(0.01 * std::exp2(ev), 0.06) << "two stops below grey";
    std::fill_n(night.begin(), 50, 0.2f); // dim lamps: until they are white
    EXPECT_NEAR(ev_of(night), std::log2(5), 0.05);
    night.assign(1000, 0.01f);
    std::fill_n(night.begin(), 10, 2.0f); // one in a hundred may burn out
    EXPECT_NEAR(ev_of(night), std::log2(0.18) - (0.99 * std::log2(0.01) + 0.01 * std::log2(2)), 0.051);
}

TEST(AutoExposure, LooksAtSurfacesAloneWhereThereAreAny) {
    std::vector<float> values(100, 0.045f);
    std::fill_n(values.begin(), 70, 5.0f); // a bright sky
    std::vector<bool> surface(100, true);
    std::fill_n(surface.begin(), 70, false);
    EXPECT_EQ(auto_exposure(of(values), surface), 2);
    EXPECT_EQ(auto_exposure(of(std::vector<float>(100, 0.36f)), std::vector<bool>(100, false)), -1);
}

TEST(AutoExposure, WhatIsBlackSaysNothingAndWhatIsInfiniteIsBright) {
    EXPECT_FALSE(auto_exposure(of(std::vector<float>(10, 0)), std::vector<bool>(10, true)));
    std::vector<float> values(100, 0.18f);
    std::fill_n(values.begin(), 60, 0.0f);
    values[98] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(ev_of(values), 0);
    EXPECT_NEAR(ev_of(std::vector<float>(10, std::numeric_limits<float>::infinity())), std::log2(0.18 / 65504), 0.051);
}

TEST(Extremes, AreCountedAsThePngHasThem) {
    Image image(10, 10);
    for (size_t i = 0; i < 100; ++i)
        image.pixels[i] = glm::vec3(0.5f);
    for (size_t i = 0; i < 30; ++i)
        image.pixels[i] = i < 15 ? glm::vec3(1, 0.2f, 0) : glm::vec3(2);
    for (size_t i = 30; i < 41; ++i)
        image.pixels[i] = glm::vec3(0.4f / 255);
    image.pixels[50] = glm::vec3(0, 0, 0.6f / 255);
    image.pixels[51] = glm::vec3(252.0f / 255);
    const Extremes found = find_extremes(image);
    EXPECT_EQ(found.burnt, 0.30);
    EXPECT_EQ(found.black, 0.11);
    EXPECT_EQ(find_extremes(Image()).black, 0);
}

} // namespace
} // namespace prelight
