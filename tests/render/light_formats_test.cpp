// Every light buffer, blended light by light and written once, against the reference.
#include "garden.hpp"
#include <prelight/error.hpp>
#include <vulkan/vulkan_core.h>

namespace prelight {
namespace {

struct Buffer {
    const char* name;
    Bound blended, once; ///< of measure.md where it names one, else what the format reaches
};
void PrintTo(const Buffer& buffer, std::ostream* out) { *out << buffer.name; }

constexpr Bound table(double psnr) { return {.psnr = psnr, .off_share = 1, .block = 255}; }

/// At most four lights on a pixel, none above what scale 2 holds.
struct FourLights : Garden {
    FourLights() {
        for (int i = 0; i < 4; ++i) {
            const float x = 0.2f * static_cast<float>(i);
            add_light(point(9, 6, {1 - x, 0.7f, 0.3f + x}), {2.6 * i - 3.9, 4.5, 1.0 + 0.3 * i});
        }
    }
    Shot shot(const char* buffer, const char* writes) const {
        Shot shot = Garden::shot();
        shot.exposure = 0.7;
        shot.settings = {{"light-buffer", buffer}, {"light-writes", writes}};
        const std::string name = buffer;
        if (name == "rgba8" || name == "packed-rgba8" || name == "rgb10a2")
            shot.settings["light-scale"] = std::string(writes) == "once" ? "8" : "2";
        return shot;
    }
};

class LightFormats : public testing::TestWithParam<std::tuple<Buffer, Shading>> {};

TEST_P(LightFormats, BlendedAndWrittenOnce) {
    const auto& [buffer, shading] = GetParam();
    FourLights garden;
    for (const char* writes : {"blended", "once"}) {
        Shot shot = garden.shot(buffer.name, writes);
        shot.shading = shading;
        expect_agrees(shot, std::string(writes) == "once" ? buffer.once : buffer.blended);
    }
}
INSTANTIATE_TEST_SUITE_P(All, LightFormats,
                         testing::Combine(testing::Values(Buffer{"rgba16f", half_float_bound, half_float_bound},
                                                          Buffer{"packed-rgba16f", half_float_bound, half_float_bound},
                                                          Buffer{"rgba8", table(40), table(37)},
                                                          Buffer{"packed-rgba8", table(40), table(37)},
                                                          Buffer{"rgb10a2", table(50), table(48)},
                                                          Buffer{"r11g11b10f", table(40), table(44)}),
                                          testing::Values(Shading::ggx, Shading::phong)),
                         [](const auto& test) {
                             std::string name = std::get<0>(test.param).name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name + (std::get<1>(test.param) == Shading::ggx ? "_ggx" : "_phong");
                         });

TEST(LightFormatsOnDrivers, AmbientAsALightIsWrittenInBothWays) {
    FourLights garden;
    for (const char* culling : {"volumes", "fullscreen", "tiles"}) {
        Shot shot = garden.shot("rgba16f", culling == std::string("volumes") ? "blended" : "once");
        shot.settings["ambient"] = "light";
        shot.settings["light-culling"] = culling;
        expect_agrees(shot);
    }
}

TEST(LightFormatsOnDrivers, HundredsOfLightsWrittenOnceLoseNothing) {
    // 512 lights on each pixel: blended half floats are several percent too dark (docs/figures.md).
    Garden garden;
    garden.add_lights(512, 60, 0.06f);
    Shot shot = garden.shot();
    shot.width = 160;
    shot.height = 90;
    shot.settings = {{"light-writes", "once"}, {"light-culling", "fullscreen"}};
    expect_agrees(shot);
}

TEST(LightFormatsOnDrivers, OnceCountsTheSamePairsAsBlended) {
    Garden garden;
    garden.add_lights(9, 3, 4);
    std::vector<Stats> stats;
    for (const char* writes : {"blended", "once"}) {
        RenderOptions options;
        options.width = 64;
        options.height = 36;
        options.count_pairs = true;
        options.settings = {{"light-writes", writes}, {"light-culling", "fullscreen"}};
        const auto renderer = create_renderer("light-prepass", &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        stats.push_back(renderer->stats());
    }
    EXPECT_GT(stats[0].pairs_contributing, 0u);
    EXPECT_EQ(stats[0].pairs_evaluated, stats[1].pairs_evaluated);
    EXPECT_EQ(stats[0].pairs_contributing, stats[1].pairs_contributing);
}

TEST(LightFormatsOnDrivers, ADeviceWithoutAFormatGetsTheNextOneAndSaysSo) {
    const struct {
        const char* buffer;
        VkFormat hidden;
        const char* note;
    } cases[] = {{"r11g11b10f", VK_FORMAT_B10G11R11_UFLOAT_PACK32, "RGBA16F is taken"},
                 {"rgb10a2", VK_FORMAT_A2B10G10R10_UNORM_PACK32, "RGBA8 is taken"}};
    for (const auto& c : cases) {
        const auto device = Device::create({.select = "cpu", .validate = true, .hidden_formats = {c.hidden}});
        FourLights garden;
        Shot shot = garden.shot(c.buffer, "blended");
        EXPECT_GE(against_reference(*device, shot).psnr, 40) << c.buffer;
        RenderOptions options = options_of(shot);
        options.width = options.height = 16;
        const auto renderer = create_renderer("light-prepass", device.get(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        ASSERT_EQ(renderer->stats().notes.size(), 2u) << c.buffer; // diffuse and specular
        EXPECT_THAT(renderer->stats().notes[0], testing::HasSubstr(c.note));
        expect_validation_clean(*device);
    }
}

TEST(LightFormatsOnDrivers, SwiftShaderStoresWhatLavapipeStores) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    FourLights garden;
    for (const char* buffer : {"rgb10a2", "r11g11b10f", "rgba8"})
        for (const char* writes : {"blended", "once"}) {
            Shot shot = garden.shot(buffer, writes);
            shot.width = 160;
            shot.height = 90;
            shot.shading = Shading::phong;
            const double theirs = against_reference(*device, shot).psnr;
            const double ours = against_reference(test_device(), shot).psnr;
            std::printf("    %s %s: %.1f dB, lavapipe %.1f dB\n", buffer, writes, theirs, ours);
            EXPECT_GE(theirs, 40) << buffer << " " << writes;
            // Sums of floats are cut off by lavapipe; all else is rounded by the shader.
            if (buffer != std::string("r11g11b10f") || writes == std::string("once")) {
                EXPECT_NEAR(theirs, ours, 1.5) << buffer << " " << writes;
            }
        }
    expect_validation_clean(*device);
}

TEST(LightFormatsOnDrivers, WhatDoesNotGoTogetherIsRefused) {
    const auto refusal = [](std::map<std::string, std::string> settings) -> std::string {
        try {
            create_renderer("light-prepass", &test_device(), {.settings = std::move(settings)});
        } catch (const UsageError& error) {
            return error.what();
        }
        return "accepted";
    };
    using testing::HasSubstr;
    EXPECT_THAT(refusal({{"light-buffer", "r11g11b10f"}, {"model", "weighted"}}), HasSubstr("no alpha"));
    EXPECT_THAT(refusal({{"light-buffer", "rgb10a2"}, {"model", "weighted"}}), HasSubstr("model=nv"));
    EXPECT_THAT(refusal({{"light-writes", "once"}, {"light-culling", "volumes"}}), HasSubstr("blends light by light"));
    EXPECT_THAT(refusal({{"light-writes", "blended"}, {"light-culling", "tiles"}}), HasSubstr("written once"));
    EXPECT_EQ(refusal({{"light-buffer", "r11g11b10f"}, {"model", "nv"}}), "accepted");
}

} // namespace
} // namespace prelight
