#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>
#include <prelight/error.hpp>
#include <prelight/metrics.hpp>

namespace prelight {
namespace {

Image filled(uint32_t width, uint32_t height, glm::vec3 value) {
    Image image(width, height);
    for (glm::vec3& pixel : image.pixels)
        pixel = value;
    return image;
}

/// A picture with content at every scale, 0 … 1.
Image pattern(uint32_t width, uint32_t height) {
    Image image(width, height);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const float wave = 0.5f + 0.5f * std::sin(static_cast<float>(x * x + 3 * y) * 0.05f);
            image.at(x, y) = {wave, static_cast<float>(x) / static_cast<float>(width),
                              (x / 7 + y / 5) % 2 ? 0.9f : 0.1f};
        }
    return image;
}

double mean(const Image& map) {
    double sum = 0;
    for (const glm::vec3& pixel : map.pixels)
        sum += static_cast<double>(pixel.r);
    return sum / static_cast<double>(map.pixels.size());
}

// Values by hand from the paper's equations, in a separate script: cmax = 41.2755 (green against
// blue), black against white: HyAB 100, 100^0.7 = 25.1189, beyond the knee of 16.5102.
TEST(Flip, UniformColoursByHand) {
    const auto flip = [](glm::vec3 a, glm::vec3 b) { return mean(flip_map(filled(40, 30, a), filled(40, 30, b))); };
    EXPECT_NEAR(flip({0, 0, 0}, {1, 1, 1}), 0.967381, 1e-4);
    EXPECT_NEAR(flip({0, 1, 0}, {0, 0, 1}), 1, 1e-4);
    EXPECT_NEAR(flip({1, 0, 0}, {0, 1, 0}), 0.986662, 1e-4);
    EXPECT_NEAR(flip(glm::vec3(0.5f), glm::vec3(0.6f)), 0.285017, 1e-4);
}

TEST(Flip, IdenticalIsZeroAndOrderDoesNotMatter) {
    const Image a = pattern(61, 37), b = filled(61, 37, {0.3f, 0.5f, 0.4f});
    EXPECT_EQ(mean(flip_map(a, a)), 0);
    EXPECT_GT(mean(flip_map(a, b)), 0.1);
    const Image ab = flip_map(a, b), ba = flip_map(b, a);
    for (size_t i = 0; i < ab.pixels.size(); ++i)
        EXPECT_EQ(ab.pixels[i], ba.pixels[i]);
}

TEST(Flip, TurnsWithThePicture) {
    const auto turned = [](const Image& image) {
        Image out(image.height, image.width);
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t x = 0; x < image.width; ++x)
                out.at(y, x) = image.at(x, y);
        return out;
    };
    const Image a = pattern(61, 37), b = filled(61, 37, {0.3f, 0.5f, 0.4f});
    const Image upright = flip_map(a, b), sideways = turned(flip_map(turned(a), turned(b)));
    for (size_t i = 0; i < upright.pixels.size(); ++i)
        EXPECT_NEAR(upright.pixels[i].r, sideways.pixels[i].r, 1e-5f);
}

// A black picture against one whose right half is white, at the last black column. Edge: all of
// the detector's negative weights see white, strength 1, so that ΔE_f = (1/√2)^½. Colour: the share
// of the luminance filter that sees white, summed here straight from the formula.
TEST(Flip, StepEdgeByHand) {
    Image step(80, 21);
    for (uint32_t y = 0; y < step.height; ++y)
        for (uint32_t x = 40; x < step.width; ++x)
            step.at(x, y) = glm::vec3(1);
    double right = 0, all = 0;
    for (int x = -10; x <= 10; ++x) {
        const double weight = std::exp(-std::numbers::pi * std::numbers::pi * x * x / (67.0 * 67.0 * 0.0047));
        all += weight;
        right += x > 0 ? weight : 0;
    }
    // The filter mixes Y, which is linear: white's share of luminance.
    const double lightness = 116 * std::cbrt(right / all) - 16;
    const double distance = std::pow(lightness, 0.7), cmax = 41.2755;
    ASSERT_GT(distance, 0.4 * cmax); // beyond the knee
    const double colour = 0.95 + (distance - 0.4 * cmax) / (0.6 * cmax) * 0.05;
    const double want = std::pow(colour, 1 - std::sqrt(1 / std::numbers::sqrt2));
    const Image map = flip_map(step, Image(80, 21));
    EXPECT_NEAR(map.at(39, 10).r, want, 1e-5);
    EXPECT_NEAR(map.at(5, 10).r, 0, 1e-6);
    EXPECT_NEAR(map.at(79, 10).r, 0.967381, 1e-4);
}

TEST(Flip, DetailBeyondTheEyeCountsLessWithMorePixelsPerDegree) {
    Image checker(64, 64);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            checker.at(x, y) = glm::vec3((x + y) % 2 ? 1.0f : 0.0f);
    const Image grey = filled(64, 64, glm::vec3(srgb_encode(0.5f)));
    EXPECT_LT(mean(flip_map(checker, grey, 200)), 0.5 * mean(flip_map(checker, grey, 20)));
}

TEST(Compare, EqualPictures) {
    const Image image = pattern(50, 40);
    const Comparison same = compare(image, image);
    EXPECT_EQ(same.psnr, std::numeric_limits<double>::infinity());
    EXPECT_EQ(same.flip, 0);
    EXPECT_EQ(same.off_share, 0);
    EXPECT_EQ(same.block, 0);
    EXPECT_EQ(same.left_out_share, 0);
}

TEST(Compare, GivesTheMapWhoseMeanFlipIs) {
    const Image picture = pattern(50, 40), reference = filled(50, 40, {0.3f, 0.5f, 0.4f});
    Image map;
    const Comparison result = compare(picture, reference, {}, &map);
    ASSERT_EQ(map.pixels.size(), 50u * 40);
    EXPECT_GT(result.flip, 0.1);
    EXPECT_NEAR(mean(map), result.flip, 1e-9);
}

TEST(Compare, PsnrByHand) {
    // Reference 0.5 everywhere: exposed to 1. The picture is 0.45, exposed to 0.9: the error is 0.1
    // in every value, PSNR 20 dB. sRGB of 0.9 is 0.954687: off by 11.55 of 255 in every pixel.
    const Comparison result = compare(filled(32, 32, glm::vec3(0.45f)), filled(32, 32, glm::vec3(0.5f)));
    EXPECT_NEAR(result.psnr, 20, 1e-4);
    EXPECT_EQ(result.off_share, 1);
    EXPECT_NEAR(result.block, 11.555, 0.01);
}

TEST(Compare, ExposesByTheReferencesPercentile) {
    // 10,000 pixels, 30,000 values; 1.5 % are 1000, the rest 4: the 99th percentile is 1000 only if
    // more than 1 % of all values are that bright. Here 0.9 % are: it is 4.
    Image reference = filled(100, 100, glm::vec3(4)), picture = reference;
    for (size_t i = 0; i < 90; ++i)
        reference.pixels[i] = picture.pixels[i] = glm::vec3(1000);
    picture.pixels[5000] = glm::vec3(2); // exposed: 0.5 against 1
    EXPECT_NEAR(compare(picture, reference).psnr, -10 * std::log10(0.25 / 10000), 1e-3);
    for (size_t i = 0; i < 150; ++i)
        reference.pixels[i] = picture.pixels[i] = glm::vec3(1000);
    EXPECT_NEAR(compare(picture, reference).psnr, -10 * std::log10(0.002 * 0.002 / 10000), 1e-3);
    // Left-out pixels have no say in the exposure: with the bright ones left out it is 4 again.
    std::vector<uint8_t> left_out(10000, 0);
    std::fill_n(left_out.begin(), 150, uint8_t(1));
    EXPECT_NEAR(compare(picture, reference, left_out).psnr, -10 * std::log10(0.25 / 9850), 1e-3);
}

TEST(Compare, SceneOfDarknessIsExposedByItsLargestValue) {
    Image reference(100, 100), picture(100, 100);
    reference.at(3, 3) = glm::vec3(8);
    picture.at(3, 3) = glm::vec3(4);
    EXPECT_NEAR(compare(picture, reference).psnr, -10 * std::log10(0.25 / 10000), 1e-3);
    EXPECT_EQ(compare(Image(9, 9), Image(9, 9)).psnr, std::numeric_limits<double>::infinity());
}

TEST(Compare, BlockFindsOneLostLight) {
    // A light that adds 1.5 % to a 16×16 patch: 1.5 of 255 in sRGB, no pixel off by more than 2,
    // PSNR far above 50 dB; only the block's mean tells.
    const Image reference = filled(320, 192, glm::vec3(1));
    Image picture = reference;
    for (uint32_t y = 64; y < 80; ++y)
        for (uint32_t x = 160; x < 176; ++x)
            picture.at(x, y) = glm::vec3(0.9866f);
    const Comparison result = compare(picture, reference);
    EXPECT_GT(result.psnr, 55);
    EXPECT_EQ(result.off_share, 0);
    EXPECT_GT(result.block, 1.4);
    EXPECT_LT(result.block, 1.6);
    EXPECT_EQ(result.block_x, 160u);
    EXPECT_EQ(result.block_y, 64u);
}

TEST(Compare, LeftOutPixelsDoNotCount) {
    const Image reference = filled(64, 64, glm::vec3(1));
    Image picture = reference;
    std::vector<uint8_t> left_out(picture.pixels.size(), 0);
    for (uint32_t x = 0; x < 64; ++x) {
        picture.at(x, 20) = glm::vec3(0);
        left_out[20 * 64 + x] = 1;
    }
    EXPECT_LT(compare(picture, reference).psnr, 25);
    EXPECT_GT(compare(picture, reference).block, 10);
    const Comparison masked = compare(picture, reference, left_out);
    EXPECT_EQ(masked.psnr, std::numeric_limits<double>::infinity());
    EXPECT_EQ(masked.off_share, 0);
    EXPECT_EQ(masked.block, 0);
    EXPECT_NEAR(masked.left_out_share, 1.0 / 64, 1e-12);
    EXPECT_GT(masked.flip, 0); // over the whole picture

    // A block with less than a quarter of its pixels counting is skipped.
    picture = reference;
    std::fill(left_out.begin(), left_out.end(), uint8_t(0));
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = 0; x < 16; ++x) {
            picture.at(x, y) = glm::vec3(0.9f);
            left_out[y * 64 + x] = y * 16 + x >= 64;
        }
    EXPECT_GT(compare(picture, reference, left_out).block, 5);
    left_out[0] = 1;
    EXPECT_EQ(compare(picture, reference, left_out).block, 0);

    std::fill(left_out.begin(), left_out.end(), uint8_t(1));
    const Comparison nothing = compare(picture, reference, left_out);
    EXPECT_EQ(nothing.psnr, 0);
    EXPECT_EQ(nothing.off_share, 1);
}

TEST(Compare, RefusesWhatCannotBeCompared) {
    const auto message = [](const Image& a, const Image& b, std::span<const uint8_t> mask = {}) {
        try {
            compare(a, b, mask);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("nothing was thrown");
    };
    using ::testing::HasSubstr;
    EXPECT_THAT(message(Image(4, 5), Image(5, 4)), HasSubstr("4x5 pixels, the reference has 5x4"));
    EXPECT_THAT(message(Image(), Image()), HasSubstr("no pixels"));
    const std::vector<uint8_t> mask(3);
    EXPECT_THAT(message(Image(2, 2), Image(2, 2), mask), HasSubstr("3 values for 4 pixels"));
    Image bad(4, 4);
    bad.at(2, 3).g = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(message(bad, Image(4, 4)), HasSubstr("picture: pixel (2, 3): NaN"));
    EXPECT_THAT(message(Image(4, 4), bad), HasSubstr("reference: pixel (2, 3): NaN"));
}

} // namespace
} // namespace prelight
