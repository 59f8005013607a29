#include <cmath>
#include <gtest/gtest.h>
#include <reference/texture.hpp>

namespace prelight::reference {
namespace {

/// 4 × 1 texels with red 0, 51, 102, 255 and alpha falling.
struct Strip : ::testing::Test {
    Scene scene;
    TextureRef ref;
    Strip() {
        scene.images.push_back({"strip", 4, 1, {0, 0, 0, 255, 51, 0, 0, 170, 102, 0, 0, 85, 255, 0, 0, 0}});
        ref.image = 0;
    }
    double red(double u, bool bilinear = true, Encoding encoding = Encoding::linear) const {
        return Textures(scene, bilinear).sample(ref, {u, 0.5}, encoding).r * 255;
    }
};

TEST_F(Strip, TexelsSitAtHalfCoordinates) {
    EXPECT_NEAR(red(0.125), 0, 1e-9);
    EXPECT_NEAR(red(0.375), 51, 1e-9);
    EXPECT_NEAR(red(0.5), 76.5, 1e-9);
    EXPECT_NEAR(red(0.4375), 51 + 0.25 * 51, 1e-9);
    EXPECT_NEAR(Textures(scene, true).sample(ref, {0.5, 0.5}, Encoding::linear).a * 255, 127.5, 1e-9);
}

TEST_F(Strip, Wraps) {
    ref.sampler.wrap_s = Wrap::repeat;
    EXPECT_NEAR(red(0), 127.5, 1e-9);
    EXPECT_NEAR(red(1.375), 51, 1e-9);
    EXPECT_NEAR(red(-0.625), 51, 1e-9);
    EXPECT_NEAR(red(1e9 + 0.375), 51, 1e-4);
    ref.sampler.wrap_s = Wrap::mirrored_repeat;
    EXPECT_NEAR(red(0), 0, 1e-9);
    EXPECT_NEAR(red(1), 255, 1e-9);
    EXPECT_NEAR(red(1.625), 51, 1e-9); // 2 − 0.375
    EXPECT_NEAR(red(-0.375), 51, 1e-9);
    ref.sampler.wrap_s = Wrap::clamp_to_edge;
    EXPECT_NEAR(red(-3), 0, 1e-9);
    EXPECT_NEAR(red(0), 0, 1e-9);
    EXPECT_NEAR(red(1), 255, 1e-9);
    EXPECT_NEAR(red(50), 255, 1e-9);
}

TEST_F(Strip, NearestOnlyWhereTheSamplerSaysSoAndIsHeard) {
    ref.sampler.mag = Filter::nearest;
    EXPECT_NEAR(red(0.49, false), 51, 1e-9);
    EXPECT_NEAR(red(0.51, false), 102, 1e-9);
    EXPECT_NEAR(red(0.5, true), 76.5, 1e-9);
    ref.sampler.mag = Filter::linear;
    EXPECT_NEAR(red(0.5, false), 76.5, 1e-9);
}

TEST_F(Strip, SrgbIsDecodedBeforeItIsMixed) {
    // 0x33 → 0.033105, 0x66 → 0.132868: their mean, not the decoded mean (0.073239).
    EXPECT_NEAR(red(0.5, true, Encoding::srgb) / 255, (0.0331048 + 0.1328683) / 2, 1e-6);
}

TEST_F(Strip, TransformIsAppliedBeforeWrapping) {
    ref.uv_linear = glm::mat2(0, 0, 0.5f, 0); // columns: u' = 0.5 v
    ref.uv_offset = {0.125f, 0.5f};
    const double got = Textures(scene, true).sample(ref, {77, 0.5}, Encoding::linear).r * 255;
    EXPECT_NEAR(got, 51, 1e-6); // u' = 0.375
}

TEST_F(Strip, MinifiedReadsTheLevelThatTheFootprintAsksFor) {
    const Textures textures(scene, false);
    ref.sampler = {.wrap_s = Wrap::clamp_to_edge, .mag = Filter::nearest, .min = Filter::nearest};
    const auto red_at = [&](double u, double texels, MipFilter mip) {
        ref.sampler.mip = mip;
        const Footprint footprint{{texels / 4, 0}, {0, 0}};
        return textures.sample(ref, {u, 0.5}, Encoding::linear, footprint).r * 255;
    };
    for (const MipFilter mip : {MipFilter::none, MipFilter::nearest, MipFilter::linear})
        EXPECT_NEAR(red_at(0.375, 1, mip), 51, 1e-9) << "one texel a pixel is magnified";
    EXPECT_NEAR(red_at(0.375, 2, MipFilter::none), 51, 1e-9);
    EXPECT_NEAR(red_at(0.375, 2, MipFilter::nearest), 25.5, 1e-9) << "level 1: the means of two";
    EXPECT_NEAR(red_at(0.875, 2, MipFilter::linear), 178.5, 1e-9);
    EXPECT_NEAR(red_at(0.375, 1.4, MipFilter::nearest), 51, 1e-9) << "nearer to level 0";
    EXPECT_NEAR(red_at(0.375, std::sqrt(2.0), MipFilter::linear), 0.5 * (51 + 25.5), 1e-9);
    EXPECT_NEAR(red_at(0.375, 4, MipFilter::nearest), 102, 1e-9) << "level 2: of all four";
    EXPECT_NEAR(red_at(0.375, 4000, MipFilter::linear), 102, 1e-9) << "there is none beyond";
    ref.sampler.min = Filter::linear;
    EXPECT_NEAR(red_at(0.5, 2, MipFilter::nearest), 102, 1e-9) << "between the two texels of level 1";
    ref.uv_linear = glm::mat2(0.5f);
    EXPECT_NEAR(red_at(0.75, 2, MipFilter::nearest), 51, 1e-9) << "the transform halves the footprint: magnified";
}

TEST(Textures, RowsRunFromTheTop) {
    Scene scene;
    scene.images.push_back({"column", 1, 2, {255, 0, 0, 255, 0, 0, 255, 255}});
    TextureRef ref;
    ref.image = 0;
    EXPECT_NEAR(Textures(scene, true).sample(ref, {0.5, 0.25}, Encoding::linear).r, 1, 1e-12);
    EXPECT_NEAR(Textures(scene, true).sample(ref, {0.5, 0.75}, Encoding::linear).b, 1, 1e-12);
}

} // namespace
} // namespace prelight::reference
