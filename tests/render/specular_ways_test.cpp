// The five ways to a material's own shininess: each against the reference of its own form, and what
// each of them approximates.
#include "garden.hpp"
#include <algorithm>
#include <prelight/error.hpp>

namespace prelight {
namespace {

constexpr const char* later_ways[] = {"luv", "fifth-channel", "luminance", "bent"};

/// Overlapping lights of several colours and shininesses, on materials that show their highlights.
struct GlossyGarden : Garden {
    GlossyGarden() {
        for (Material& material : scene.materials)
            material.metallic = 1;
        scene.materials[0].metallic = 0.7f;
        for (int i = 0; i < 6; ++i) {
            const float x = 0.15f * static_cast<float>(i);
            Light light = point(14, 4, {1 - x, 0.8f, 0.3f + x});
            light.shininess = i % 2 ? 3.0f : 1.0f;
            add_light(light, {2.0 * i - 5, 4.2, 0.7 * (i % 3) - 0.5});
        }
    }
    Shot shot(const std::string& way) const {
        Shot shot = Garden::shot();
        shot.shading = Shading::phong;
        shot.settings = {{"specular", way}};
        return shot;
    }
};

class SpecularWays : public testing::TestWithParam<const char*> {};

TEST_P(SpecularWays, AgreeWithTheirOwnFormula) {
    GlossyGarden garden;
    expect_agrees(garden.shot(GetParam()));
}

TEST_P(SpecularWays, AmbientAsALight) {
    GlossyGarden garden;
    Shot shot = garden.shot(GetParam());
    shot.settings["ambient"] = "light";
    expect_agrees(shot);
}

TEST_P(SpecularWays, InEightBits) {
    GlossyGarden garden;
    Shot shot = garden.shot(GetParam());
    shot.settings["light-buffer"] = "packed-rgba8";
    shot.exposure = 0.7;
    expect_agrees(shot, rgba8_bound); // more figures: docs/accuracy.md
}

TEST_P(SpecularWays, AreNotAnyOther) {
    GlossyGarden garden;
    const Shot shot = garden.shot(GetParam());
    const auto picture = [&](const std::string& way) {
        Shot other = shot;
        other.settings = {{"specular", way}};
        other.settings["ambient"] = "light"; // parts the fifth channel from luminance
        ReferenceForm form = form_of(other);
        form.mono_specular = true;
        return render_reference(garden.world, garden.camera, 96, 54, 0, form).linear;
    };
    for (const char* other : {"stored", "fifth-channel", "luminance", "bent"}) {
        const bool same =
            std::string(other) == GetParam() || (std::string(other) == "luminance" && std::string(GetParam()) == "luv");
        if (!same) {
            EXPECT_LT(compare_pixels(picture(GetParam()), picture(other)).psnr, 55) << other;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, SpecularWays, testing::ValuesIn(later_ways), [](const auto& way) {
    std::string name = way.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(OwnShininess, LuvIsWrittenOnceByEveryWayThatCan) {
    GlossyGarden garden;
    for (const char* culling : {"fullscreen", "tiles", "clusters"})
        for (const char* ambient : {"material", "light"}) {
            Shot shot = garden.shot("luv");
            shot.width = 160;
            shot.height = 90;
            shot.settings["light-culling"] = culling;
            shot.settings["ambient"] = ambient;
            expect_agrees(shot);
        }
}

/// Ambient light is on surfaces that no lamp reaches too.
TEST(OwnShininess, AmbientLightIsWhereNoLampIs) {
    Garden garden;
    Light lamp = garden.point(1.5f, 6, {0.9f, 1, 0.6f});
    lamp.shininess = 2;
    garden.add_light(lamp, {0.5, 1, 2});
    for (const char* way : {"luv", "luminance"}) {
        Shot shot = garden.shot();
        shot.shading = Shading::phong;
        shot.width = 160;
        shot.height = 90;
        shot.settings = {{"specular", way}, {"ambient", "light"}, {"light-culling", "tiles"}};
        const Image linear = render_linear(test_device(), shot);
        shot.settings["light-culling"] = "fullscreen";
        shot.settings["light-writes"] = "once";
        EXPECT_GE(compare_pixels(linear, render_linear(test_device(), shot)).psnr, 60) << way;
        EXPECT_GT(std::ranges::count_if(linear.pixels, [](const glm::vec3& p) { return p.y > 0; }), 160 * 90 / 3)
            << way;
    }
    expect_validation_clean(test_device());
}

/// One light on every pixel: ways 2, 3 and 4 then are exactly Σ N·L att (N·H)^(n·mn).
TEST(OwnShininess, OfOneLightAreWhatTheyApproximate) {
    Garden garden;
    Light light = garden.point(14, 16, {0.9f, 1, 0.6f});
    light.shininess = 2;
    garden.add_light(light, {0.5, 4, 2});
    Shot stored = garden.shot();
    stored.shading = Shading::phong;
    ReferenceForm target = form_of(stored);
    target.mono_specular = true;
    target.specular_antialiasing = false; // sums of light know no stored roughness
    const ReferencePicture reference = render_reference(garden.world, garden.camera, 320, 180, 0, target);
    for (const char* way : {"luv", "fifth-channel", "luminance"}) {
        Shot shot = stored;
        shot.settings = {{"specular", way}};
        const Comparison c = compare_pixels(render_linear(test_device(), shot), reference.linear, reference.left_out());
        EXPECT_GE(c.psnr, half_float_bound.psnr) << way;
        EXPECT_LE(c.off_share, half_float_bound.off_share) << way;
    }
    expect_validation_clean(test_device());
}

TEST(OwnShininess, NothingIsDividedByZeroInTheDark) {
    Garden garden;
    Light light = garden.point(1.5f, 4);
    garden.add_light(light, {-4, 2.4, 0.8}); // most of the picture has no light at all
    garden.world.ambient = {0, 0, 0};
    for (Material& material : garden.scene.materials)
        material.emissive = {0, 0, 0};
    garden.scene.materials[0].roughness = 1; // exponent 0, and 0⁰ must not glow
    for (const char* way : later_ways) {
        Shot shot = garden.shot();
        shot.shading = Shading::phong;
        shot.settings = {{"specular", way}};
        const Image picture = render_linear(test_device(), shot);
        const Image reference = render_reference(garden.world, garden.camera, 320, 180, 0, form_of(shot)).linear;
        for (size_t i = 0; i < picture.pixels.size(); ++i) {
            ASSERT_TRUE(std::isfinite(picture.pixels[i].x)) << way;
            if (reference.pixels[i] == glm::vec3(0)) {
                ASSERT_EQ(picture.pixels[i], glm::vec3(0)) << way;
            }
        }
    }
    expect_validation_clean(test_device());
}

TEST(OwnShininess, SettingsTakeWhatTheyNeed) {
    const auto in_force = [](std::map<std::string, std::string> settings) {
        RenderOptions options;
        options.width = options.height = 16;
        options.shading = Shading::phong;
        options.settings = std::move(settings);
        Garden garden;
        const auto renderer = create_renderer("light-prepass", &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        return renderer->stats().settings;
    };
    auto settings = in_force({{"specular", "luminance"}});
    EXPECT_EQ(settings["light-buffer"], "packed-rgba16f");
    EXPECT_EQ(settings["light-writes"], "once");
    EXPECT_EQ(settings["light-culling"], "tiles"); // auto
    settings = in_force({{"specular", "luminance"}, {"light-writes", "blended"}});
    EXPECT_EQ(settings["light-culling"], "volumes");
    settings = in_force({{"specular", "luv"}, {"light-buffer", "packed-rgba8"}});
    EXPECT_EQ(settings["light-buffer"], "packed-rgba8");
    EXPECT_EQ(settings["light-writes"], "once");
    EXPECT_NE(settings["light-culling"], "volumes");
}

TEST(OwnShininess, WhatDoesNotGoTogetherIsRefused) {
    const auto refusal = [](Shading shading, std::map<std::string, std::string> settings) -> std::string {
        try {
            RenderOptions options;
            options.shading = shading;
            options.settings = std::move(settings);
            create_renderer("light-prepass", &test_device(), options);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "accepted";
    };
    using testing::HasSubstr;
    for (const char* way : later_ways)
        EXPECT_THAT(refusal(Shading::ggx, {{"specular", way}}), HasSubstr("phong"));
    EXPECT_THAT(refusal(Shading::phong, {{"specular", "luminance"}, {"light-buffer", "rgba16f"}}),
                HasSubstr("packed-rgba16f"));
    EXPECT_THAT(refusal(Shading::phong, {{"specular", "bent"}, {"light-buffer", "rgba8"}}), HasSubstr("packed-rgba8"));
    EXPECT_THAT(refusal(Shading::phong, {{"specular", "luv"}, {"light-culling", "volumes"}}),
                HasSubstr("blends light by light"));
    EXPECT_THAT(refusal(Shading::phong, {{"specular", "luv"}, {"light-writes", "blended"}}), HasSubstr("written once"));
    for (const char* way : {"luv", "fifth-channel", "luminance"})
        EXPECT_THAT(refusal(Shading::phong, {{"specular", way}, {"specular-gate", "step"}}),
                    HasSubstr("specular-gate"));
    EXPECT_EQ(refusal(Shading::phong, {{"specular", "bent"}, {"specular-gate", "step"}}), "accepted");
}

} // namespace
} // namespace prelight
