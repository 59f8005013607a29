// A device that cannot draw into a format gets the next one, and the log says so.
#include "garden.hpp"
#include <vulkan/vulkan_core.h>

namespace prelight {
namespace {

struct Fallback {
    const char* setting;
    const char* value;
    std::vector<uint32_t> hidden;
    const char* note;
    double psnr; ///< what the format in its place reaches is a figure, not the half-float bound
};

TEST(FormatFallback, TheNextFormatIsTakenAndNamed) {
    for (const Fallback& f :
         {Fallback{"normals", "oct32", {VK_FORMAT_R16G16_UNORM}, "RG32F is taken", 55},
          Fallback{"normals", "rgb10a2", {VK_FORMAT_A2B10G10R10_UNORM_PACK32}, "RGBA8 is taken", 40},
          Fallback{"normals", "oct16", {VK_FORMAT_R8G8_UNORM}, "RGBA8 is taken", 35},
          Fallback{"normals", "xy16f", {VK_FORMAT_R16G16_SFLOAT}, "RG32F is taken", 55},
          Fallback{"normals", "oct32", {VK_FORMAT_R16_SFLOAT}, "roughness: R16F is no target", 55},
          Fallback{"depth", "r32f", {VK_FORMAT_R32_SFLOAT}, "R16F is taken", 40},
          Fallback{"depth", "r32f", {VK_FORMAT_R32_SFLOAT, VK_FORMAT_R16_SFLOAT}, "RGBA8 is taken", 55},
          Fallback{"depth", "r16f", {VK_FORMAT_R16_SFLOAT}, "RGBA8 is taken", 55}}) {
        const auto device = Device::create({.select = "cpu", .validate = true, .hidden_formats = f.hidden});
        Garden garden;
        garden.add_lights(12, 4, 6);
        Shot shot = garden.shot();
        shot.width = 160;
        shot.height = 90;
        shot.settings = {{f.setting, f.value}};
        EXPECT_GE(against_reference(*device, shot).psnr, f.psnr) << f.note;
        const auto renderer =
            create_renderer("light-prepass", device.get(), {.width = 16, .height = 16, .settings = shot.settings});
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        ASSERT_EQ(renderer->stats().notes.size(), 1u);
        EXPECT_THAT(renderer->stats().notes[0], testing::HasSubstr(f.note));
        expect_validation_clean(*device);
    }
}

TEST(FormatFallback, NothingIsSaidWhenNothingIsMissing) {
    Garden garden;
    const auto renderer = create_renderer("light-prepass", &test_device(),
                                          {.width = 16, .height = 16, .settings = {{"normals", "oct32"}}});
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_TRUE(renderer->stats().notes.empty());
}

} // namespace
} // namespace prelight
