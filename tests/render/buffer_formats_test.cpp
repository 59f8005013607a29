// Every way to store light, against the reference.
#include "garden.hpp"

namespace prelight {
namespace {

TEST(LightBuffers, PackedRgba8BlendedWithScale2) {
    FewLights garden;
    Shot shot = garden.shot();
    shot.settings = {{"light-buffer", "packed-rgba8"}, {"light-scale", "2"}};
    shot.exposure = 0.7;
    for (const Shading shading : {Shading::ggx, Shading::phong}) {
        shot.shading = shading;
        expect_agrees(shot, rgba8_bound);
    }
}

TEST(LightBuffers, PackedRgba8ClipsWhatItsScaleDoesNotHold) {
    FewLights garden;
    Shot shot = garden.shot();
    shot.settings = {{"light-buffer", "packed-rgba8"}, {"light-scale", "0.1"}};
    shot.exposure = 0.7;
    EXPECT_LT(against_reference(test_device(), shot).psnr, rgba8_bound.psnr);
}

TEST(LightBuffers, ABrightLightIsNotDimmedByTheNumberOfOthers) {
    FewLights garden;
    garden.add_light(garden.point(20, 2e5f), {0, 6, 4});
    for (int i = 0; i < 40; ++i)
        garden.add_light(garden.point(0.1f, 1), {100.0 + i, 0, 0});
    Shot shot = garden.shot();
    shot.exposure = 0; // sums of thousands, below the largest half float
    expect_agrees(shot);
}

TEST(LightBuffers, NeverHoldInfinity) {
    Garden garden;
    garden.add_light(garden.point(50, 1e6f), {0, 2.05, 0.8});
    for (int i = 0; i < 40; ++i)
        garden.add_light(garden.point(50, 1e5f), {0.01 * i, 3, 0});
    for (const float pixel : {0.0f, 12.0f}) {
        Shot shot = garden.shot();
        shot.exposure = pixel;
        const Image picture = render_linear(test_device(), shot);
        for (const glm::vec3& value : picture.pixels)
            for (int c = 0; c < 3; ++c) {
                ASSERT_TRUE(std::isfinite(value[c]));
                ASSERT_LE(value[c], 65504.0f);
            }
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
