// Several samples a pixel on a second driver. It places vertices on a 16th of a pixel, so that its edges lie beside the
// reference's: means are what can be judged.
#include "garden.hpp"

namespace prelight {
namespace {

TEST(SamplesOnSwiftShader, AgreeWithTheReferenceInTheMean) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    Garden garden;
    garden.add_lights(6, 4, 6);
    for (const char* name : {"light-prepass", "deferred", "z-prepass"}) {
        SCOPED_TRACE(name);
        Shot shot = garden.shot();
        shot.renderer = name;
        shot.samples = 4;
        const auto renderer = create_renderer(name, device, options_of(shot));
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        const Image picture = renderer->read("linear");
        const Stats stats = renderer->stats();
        if (std::string(name) == "light-prepass") {
            EXPECT_EQ(stats.settings.at("msaa-material"), "sample");
            EXPECT_THAT(stats.notes, testing::Contains(testing::HasSubstr("depth under the pixel's centre")));
        }
        ReferenceForm form = form_of(shot);
        form.samples = reference_form(shot.shading, stats.settings, shot.samples).samples;
        const ReferencePicture reference =
            render_reference(garden.world, garden.camera, shot.width, shot.height, 0, form);
        save_when_wanted(picture, reference);
        const Comparison c = compare_pixels(picture, reference.linear);
        std::printf("    %.1f dB, block %.2f/255\n", c.psnr, c.block);
        EXPECT_GE(c.psnr, 40);
        EXPECT_LE(c.block, half_float_bound.block);
        expect_validation_clean(*device);
    }
}

} // namespace
} // namespace prelight
