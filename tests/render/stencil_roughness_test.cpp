// The first of Engel's ways to a material's own specular power, in his other place for it: the stencil buffer.
#include "decal_world.hpp"
#include "every_way.hpp"
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <vulkan/vulkan_core.h>

namespace prelight {
namespace {

using Words = std::map<std::string, std::string>;

Shot lit(const Garden& garden, const Words& settings, Shading shading = Shading::phong) {
    Shot shot = garden.shot();
    shot.width = 160;
    shot.height = 90;
    shot.shading = shading;
    shot.exposure = shading == Shading::phong ? -1 : 0;
    shot.settings = settings;
    return shot;
}

struct SevenLights : Garden {
    SevenLights() { add_lights(7, 6, 6); }
};

/// Both hold the same code of eight bits.
void expect_same_in_stencil(Shot shot) {
    SCOPED_TRACE(name_of(shot));
    const Image beside = render_linear(test_device(), shot);
    shot.settings["roughness"] = "stencil";
    EXPECT_TRUE(render_linear(test_device(), shot).pixels == beside.pixels);
    expect_validation_clean(test_device());
}

TEST(PowerInStencil, IsTheSamePictureAsBesideTheNormal) {
    const SevenLights garden;
    expect_same_in_stencil(lit(garden, {}, Shading::ggx));
    for (const Words& settings : {Words{},
                                  {{"normals", "rgb8"}, {"normal-space", "view"}},
                                  {{"geometry", "two-passes"}},
                                  {{"depth", "r32f"}},
                                  {{"geometry", "two-passes"}, {"depth", "rgba8"}},
                                  {{"light-buffer", "packed-rgba16f"}},
                                  {{"light-buffer", "rgba8"}}})
        expect_same_in_stencil(lit(garden, settings));
}

TEST(PowerInStencil, IsReadByEveryWayInWhichLightsFindTheirPixels) {
    SevenLights garden;
    garden.add_light(garden.spot(0.7f, 10, 9), {3.5, 5, 1.6}, {-0.1, -1, -0.2});
    garden.add_light({.kind = LightKind::directional, .intensity = 0.2f}, {0, 0, 0}, {-0.3, -1, -0.5});
    References references;
    for (const char* culling : {"fullscreen", "rectangles", "volumes", "tiles", "clusters"})
        references.expect_agrees(lit(garden, {{"light-culling", culling}, {"roughness", "stencil"}}, Shading::ggx));
    for (const char* culling : {"volumes", "tiles"})
        expect_same_in_stencil(
            lit(garden, {{"light-culling", culling}, {"shadows", "on"}, {"shadow-budget", "1048576"}}));
    expect_same_in_stencil(lit(garden, {{"light-culling", "tiles"}, {"list-shading", "fragment"}}));
    expect_same_in_stencil(lit(garden, {{"light-culling", "tiles"}, {"light-lists", "perfect"}}));
    expect_same_in_stencil(lit(garden, {{"light-culling", "fullscreen"}, {"light-writes", "once"}}));
}

TEST(PowerInStencil, AgreesWithTheReferenceWithoutATargetOfItsOwn) {
    const SevenLights garden;
    for (const char* normals : {"oct32", "rgb10a2"}) {
        SCOPED_TRACE(normals);
        Shot shot = lit(garden, {{"normals", normals}, {"roughness", "stencil"}}, Shading::ggx);
        expect_agrees(shot);
        const auto bytes = [&](const Shot& one) {
            const auto renderer = create_renderer("light-prepass", &test_device(), options_of(one));
            renderer->set_world(garden.world);
            renderer->render(garden.camera);
            return renderer->stats().attachment_bytes_unshared;
        };
        Shot beside = shot;
        beside.settings.erase("roughness");
        // A half float for roughness less, a byte of stencil more.
        EXPECT_EQ(bytes(beside) - bytes(shot), 160u * 90) << normals;
    }
}

TEST(PowerInStencil, KnowsDecalsMasksAndOwnMaterials) {
    DecalGarden decals;
    decals.add_lights(6, 6, 6);
    expect_same_in_stencil(lit(decals, {}));
    expect_same_in_stencil(lit(decals, {{"geometry", "two-passes"}}));
    SevenLights own;
    for (size_t m = 1; m < own.scene.materials.size(); ++m)
        own.scene.materials[m].shader = find_material_shader(m % 2 ? "skin" : "detailed");
    expect_same_in_stencil(lit(own, {}));
    expect_same_in_stencil(lit(own, {{"depth", "r32f"}}));
    MixedMaterials masked;
    Shot shot = masked.shot();
    shot.shading = Shading::phong;
    expect_same_in_stencil(shot);
}

TEST(PowerInStencil, IsShownByTheViewOfRoughness) {
    const SevenLights garden;
    std::vector<Image> views;
    for (const char* place : {"normal", "stencil"}) {
        RenderOptions options = options_of(lit(garden, {{"roughness", place}}));
        options.views = {"roughness", "light-count", "normal", "diffuse-light"};
        const auto renderer = create_renderer("light-prepass", &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        for (const std::string& view : options.views)
            views.push_back(renderer->read(view));
    }
    for (size_t v = 0; v < 4; ++v)
        EXPECT_TRUE(views[v].pixels == views[v + 4].pixels) << v;
    expect_validation_clean(test_device());
}

TEST(PowerInStencil, IsRefusedWhereStencilIsTakenOrPowerIsNotStored) {
    const auto refusal = [](Words settings, Shading shading) -> std::string {
        settings["roughness"] = "stencil";
        try {
            create_renderer("light-prepass", &test_device(), {.shading = shading, .settings = settings});
        } catch (const UsageError& error) {
            return error.what();
        }
        return "accepted";
    };
    using testing::HasSubstr;
    EXPECT_THAT(refusal({{"light-culling", "stencil"}}, Shading::ggx),
                HasSubstr("light-culling=stencil marks lights there"));
    EXPECT_THAT(refusal({{"specular", "luminance"}}, Shading::phong), HasSubstr("needs specular=stored"));
    EXPECT_EQ(refusal({}, Shading::phong), "accepted");
}

TEST(PowerInStencil, GoesBesideTheNormalWhereFragmentsCannotWriteStencil) {
    const auto device = Device::create(
        {.select = "cpu", .validate = true, .hidden_extensions = {VK_EXT_SHADER_STENCIL_EXPORT_EXTENSION_NAME}});
    const SevenLights garden;
    const Shot shot = lit(garden, {{"roughness", "stencil"}});
    const auto renderer = create_renderer("light-prepass", device.get(), options_of(shot));
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_EQ(renderer->stats().settings.at("roughness"), "normal");
    ASSERT_EQ(renderer->stats().notes.size(), 1u);
    EXPECT_THAT(renderer->stats().notes[0], testing::HasSubstr("normal is taken"));
    EXPECT_TRUE(renderer->read("linear").pixels == render_linear(test_device(), lit(garden, {})).pixels);
    expect_validation_clean(*device);
}

// Its export is wrong on some surfaces, so that it is not relied on.
TEST(PowerInStencil, GoesBesideTheNormalOnSwiftShader) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    const SevenLights garden;
    for (const char* culling : {"volumes", "tiles"}) {
        Shot shot = lit(garden, {{"light-culling", culling}}, Shading::ggx);
        const Image beside = render_linear(*device, shot);
        shot.settings["roughness"] = "stencil";
        EXPECT_TRUE(render_linear(*device, shot).pixels == beside.pixels) << culling;
    }
    expect_validation_clean(*device);
}

} // namespace
} // namespace prelight
