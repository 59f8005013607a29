// The presets, exactly as the source texts configure the light pre-pass.
#include "garden.hpp"
#include <cstdlib>
#include <prelight/error.hpp>
#include <vulkan/vulkan_core.h>

namespace prelight {
namespace {

using Words = std::map<std::string, std::string>;

struct Preset {
    const char* name;
    Words settings; ///< what makes it that preset
    double psnr;    ///< with eight bits of light and normals of its own
};
void PrintTo(const Preset& preset, std::ostream* out) { *out << preset.name; }

/// At most four lights on a pixel, none above what scale 2 holds; all kinds of volumes.
struct PresetGarden : Garden {
    PresetGarden() {
        add_light(point(9, 6), {-3.9, 4.5, 1});
        add_light(point(9, 6, {0.5f, 0.7f, 1}), {-0.5, 4.5, 1.5});
        add_light(spot(0.7f, 10, 9), {3.5, 5, 1.6}, {-0.1, -1, -0.2});
        add_light({.kind = LightKind::directional, .intensity = 0.2f}, {0, 0, 0}, {-0.3, -1, -0.5});
    }
};

RenderOptions options_for(const char* preset, Shading shading) {
    RenderOptions options;
    options.width = 320;
    options.height = 180;
    options.shading = shading;
    options.exposure = 0.7;
    options.preset = preset;
    options.settings = {{"texture-filter", "bilinear"}};
    return options;
}

class Presets : public testing::TestWithParam<Preset> {};

TEST_P(Presets, AgreeWithTheReferenceOfTheirForm) {
    PresetGarden garden;
    for (const Shading shading : {Shading::ggx, Shading::phong}) {
        const RenderOptions options = options_for(GetParam().name, shading);
        const Rendered ours = render_with(garden.world, garden.camera, options);
        const ReferencePicture reference = render_reference(garden.world, garden.camera, 320, 180, options.exposure,
                                                            reference_form(shading, ours.stats.settings));
        const Comparison c = compare_pixels(ours.linear, reference.linear, reference.left_out());
        std::printf("    %.1f dB, %.3f %% off, block %.2f/255\n", c.psnr, c.off_share * 100, c.block);
        EXPECT_GE(c.psnr, GetParam().psnr);
        if (const char* folder = std::getenv("PRELIGHT_TEST_PICTURES"))
            save_png(tonemap(ours.linear, Tonemap::none), std::string(folder) + "/preset-" + GetParam().name +
                                                              (shading == Shading::ggx ? "-ggx" : "-phong") + ".png");
    }
    expect_validation_clean(test_device());
}

TEST_P(Presets, HaveTheirSettingsInForce) {
    PresetGarden garden;
    RenderOptions options = options_for(GetParam().name, Shading::phong);
    options.shading.reset(); // the source text's own
    if (GetParam().settings.contains("shadow-memory"))
        options.settings["shadows"] = "on"; // without them it says nothing
    const Rendered ours = render_with(garden.world, garden.camera, options);
    for (const auto& [key, value] : GetParam().settings)
        EXPECT_EQ(ours.stats.settings.at(key), value) << key;
    EXPECT_TRUE(ours.stats.notes.empty());
    EXPECT_EQ(ours.stats.shading, Shading::phong);
}

TEST_P(Presets, AreListedAndGiveWayToTheUser) {
    for (const RendererInfo& info : renderer_infos())
        if (info.name == "light-prepass") {
            EXPECT_THAT(info.presets, testing::Contains(GetParam().name));
            for (const auto& [key, value] : GetParam().settings)
                EXPECT_EQ(info.preset_settings.at(GetParam().name).at(key), value);
        }
    RenderOptions options = options_for(GetParam().name, Shading::phong);
    options.width = options.height = 16;
    options.settings["light-buffer"] = "packed-rgba16f";
    options.settings["normals"] = "oct32";
    PresetGarden garden;
    const Rendered ours = render_with(garden.world, garden.camera, options);
    EXPECT_EQ(ours.stats.settings.at("light-buffer"), "packed-rgba16f");
    EXPECT_EQ(ours.stats.settings.at("normals"), "oct32");
    EXPECT_EQ(ours.stats.settings.at("light-culling"), GetParam().settings.at("light-culling"));
}

INSTANTIATE_TEST_SUITE_P(All, Presets,
                         testing::Values(Preset{"engel",
                                                {{"normals", "spherical"},
                                                 {"normal-space", "world"},
                                                 {"light-buffer", "packed-rgba8"},
                                                 {"specular", "luminance"},
                                                 {"light-culling", "volumes"}},
                                                50},
                                         Preset{"round2",
                                                {{"depth", "r32f"},
                                                 {"normals", "rgb10a2"},
                                                 {"position", "ray"},
                                                 {"ambient", "light"},
                                                 {"light-buffer", "packed-rgba8"},
                                                 {"specular-vector", "reflection"},
                                                 {"light-culling", "volumes"},
                                                 {"spot-volume", "cone"},
                                                 {"volume-depth-test", "off"}},
                                                50},
                                         Preset{"prelighting",
                                                {{"normals", "rgb8"},
                                                 {"normal-space", "view"},
                                                 {"light-buffer", "rgba8"},
                                                 {"specular", "stored"},
                                                 {"light-culling", "rectangles"},
                                                 {"shadow-memory", "reuse"}},
                                                50}),
                         [](const auto& preset) { return std::string(preset.param.name); });

TEST(LightPrepassPresets, EngelTakesEachOfItsThreeWays) {
    PresetGarden garden;
    std::vector<Image> pictures;
    for (const char* way : {"fifth-channel", "luminance", "bent"}) {
        RenderOptions options = options_for("engel", Shading::phong);
        options.settings["specular"] = way;
        const Rendered ours = render_with(garden.world, garden.camera, options);
        EXPECT_EQ(ours.stats.settings.at("specular"), way);
        EXPECT_EQ(ours.stats.settings.at("light-buffer"), "packed-rgba8");
        const Image reference = render_reference(garden.world, garden.camera, 320, 180, options.exposure,
                                                 reference_form(Shading::phong, ours.stats.settings))
                                    .linear;
        EXPECT_GE(compare_pixels(ours.linear, reference).psnr, 38) << way;
        pictures.push_back(ours.linear);
    }
    EXPECT_FALSE(pictures[1].pixels == pictures[2].pixels);
}

TEST(LightPrepassPresets, AWayOfPhongIsNotTakenInGgxAndThatIsSaid) {
    PresetGarden garden;
    const Rendered ours = render_with(garden.world, garden.camera, options_for("engel", Shading::ggx));
    EXPECT_EQ(ours.stats.settings.at("specular"), "stored");
    ASSERT_EQ(ours.stats.notes.size(), 1u);
    EXPECT_THAT(ours.stats.notes[0], testing::HasSubstr("specular=luminance: is a way of --shading phong"));
}

TEST(LightPrepassPresets, PrelightingPutsNormalsIntoTheMemoryOfTheFrame) {
    PresetGarden garden;
    // The material pass holds depth, two light buffers (4 bytes each) and the frame (4, and 8 when it
    // is scene-linear): 16 or 20 bytes a pixel, all alive. The light pass holds the first three as
    // well, and the normals: when nothing is beyond those bytes, the normals lie in the frame's.
    RenderOptions options = options_for("prelighting", Shading::phong);
    EXPECT_EQ(render_with(garden.world, garden.camera, options).stats.attachment_bytes, 16u * 320 * 180);
    options.views = {"linear"};
    EXPECT_EQ(render_with(garden.world, garden.camera, options).stats.attachment_bytes, 20u * 320 * 180);
}

// Lee: each light's maps in the memory of the light before. Lists read all maps at once: there the preset gives way.
TEST(LightPrepassPresets, PrelightingReusesShadowMemoryLightByLight) {
    PresetGarden garden;
    RenderOptions options = options_for("prelighting", Shading::phong);
    options.settings.insert({{"shadows", "on"}, {"shadow-detail", "0.25"}}); // so that all of them fit
    const Stats stats = render_with(garden.world, garden.camera, options).stats;
    EXPECT_EQ(stats.settings.at("shadow-memory"), "reuse");
    EXPECT_EQ(stats.settings.at("light-culling"), "rectangles");
    const uint64_t together = [&] {
        options.settings["shadow-memory"] = "atlas";
        return render_with(garden.world, garden.camera, options).stats.shadows->texels;
    }();
    EXPECT_LT(stats.shadows->texels, together) << "one light's maps, not all";
    options.settings.erase("shadow-memory");
    options.settings["light-culling"] = "tiles";
    const Stats lists = render_with(garden.world, garden.camera, options).stats;
    EXPECT_EQ(lists.settings.at("shadow-memory"), "atlas");
    EXPECT_THAT(lists.notes,
                testing::Contains(testing::HasSubstr("shadow-memory=reuse: is for lights that are drawn one by one")));
    options.settings["shadow-memory"] = "reuse";
    EXPECT_THROW(create_renderer("light-prepass", &test_device(), options), UsageError);
    expect_validation_clean(test_device());
}

TEST(LightPrepassPresets, ADeviceWithoutTheFormatsTakesTheSourceTextsFallbacks) {
    // Round 2: R32F, or R16F, or RGBA8; 10:10:10:2, or RGBA8.
    const auto device = Device::create({.select = "cpu",
                                        .validate = true,
                                        .hidden_formats = {VK_FORMAT_R32_SFLOAT, VK_FORMAT_A2B10G10R10_UNORM_PACK32}});
    PresetGarden garden;
    RenderOptions options = options_for("round2", Shading::phong);
    options.width = options.height = 16;
    const auto renderer = create_renderer("light-prepass", device.get(), options);
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    std::string notes;
    for (const std::string& note : renderer->stats().notes)
        notes += note + "\n";
    EXPECT_THAT(notes, testing::HasSubstr("R16F is taken"));
    EXPECT_THAT(notes, testing::HasSubstr("RGBA8 is taken"));
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
