// A smoke of the same pictures on a second driver.
#include "decal_world.hpp"
#include "garden.hpp"
#include <prelight/light_distribution.hpp>
#include <scene/procedural/cookie_maps.hpp>

namespace prelight {
namespace {

class SwiftShader : public testing::Test {
protected:
    void SetUp() override {
        device_ = swiftshader_device();
        if (!device_)
            GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    }
    Device* device_ = nullptr;
};

TEST_F(SwiftShader, EveryLightBufferAndEncodingAgreesWithTheReference) {
    Garden garden;
    garden.add_lights(6, 4, 6);
    garden.add_light(garden.spot(0.6f, 8, 30), {1, 4, 2}, {0, -1, -0.2});
    garden.add_light({.kind = LightKind::directional, .intensity = 0.4f}, {0, 0, 0}, {-0.3, -1, -0.5});
    const std::map<std::string, std::string> settings[] = {
        {},
        {{"light-buffer", "packed-rgba16f"}, {"normals", "oct32"}, {"normal-space", "view"}},
        {{"normals", "rgb10a2"}, {"depth", "r32f"}, {"position", "matrix"}, {"model", "nv"}},
        {{"normals", "spherical"}, {"depth", "rgba8"}},
        {{"normals", "xy16f"}, {"normal-space", "view"}, {"depth", "rgba8"}, {"geometry", "two-passes"}}};
    for (const auto& set : settings) {
        Shot shot = garden.shot();
        shot.settings = set;
        const Comparison c = against_reference(*device_, shot);
        EXPECT_GE(c.psnr, half_float_bound.psnr);
        EXPECT_LE(c.off_share, half_float_bound.off_share);
        EXPECT_LE(c.block, half_float_bound.block);
        expect_validation_clean(*device_);
    }
}

// Cookies and profiles: bilinear filtering is coarser there (8 bits between texels).
TEST_F(SwiftShader, CookiesAndProfilesAgreeWithTheReference) {
    Garden garden;
    garden.scene.images = {window_cookie(), lantern_cookie(), dice_cookie()};
    Light window = garden.spot(0.6f, 14, 70), lantern = garden.point(9, 9), dice = garden.point(8, 8),
          lamp = garden.point(9, 8);
    window.cookie = 0, lantern.cookie = 1, dice.cookie = 2;
    lamp.profile = std::make_shared<const LightProfile>(parse_profile(wall_lamp_profile(), "wall lamp"));
    garden.add_light(window, {3, 5.5, 4}, {-0.5, -1, -0.7});
    garden.add_light(lantern, {-2.5, 2.4, 2.4}, {0.3, -0.2, -1});
    garden.add_light(dice, {2.2, 2.6, -1}, {-0.6, 0.2, -1});
    garden.add_light(lamp, {-4, 3, -2}, {0.3, -1, 0.2});
    for (const char* culling : {"volumes", "tiles"}) {
        Shot shot = garden.shot();
        shot.width = 160, shot.height = 90;
        shot.settings["light-culling"] = culling;
        const Comparison c = against_reference(*device_, shot);
        EXPECT_GE(c.psnr, half_float_bound.psnr);
        EXPECT_LE(c.off_share, half_float_bound.off_share);
        EXPECT_LE(c.block, half_float_bound.block);
        expect_validation_clean(*device_);
    }
}

// It divides by w less exactly than others: faces of cubes that look straight at a surface showed it.
TEST_F(SwiftShader, ShadowsAgreeWithShadowRays) {
    Garden garden;
    garden.add_light(garden.point(9, 7), {-1, 2.6, 2.2}, {0, -1, 0});
    garden.add_light(garden.spot(0.6f, 12, 40), {4, 5, 3}, glm::normalize(glm::dvec3(-0.7, -1, -0.6)));
    garden.add_light({.kind = LightKind::directional, .intensity = 0.8f}, {0, 0, 0},
                     glm::normalize(glm::dvec3(-0.5, -1, -0.3)));
    for (const char* memory : {"atlas", "reuse"}) {
        Shot shot = garden.shot();
        shot.settings = {
            {"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}, {"shadow-memory", memory}};
        const Comparison c = against_reference(*device_, shot);
        EXPECT_GE(c.psnr, half_float_bound.psnr);
        EXPECT_LE(c.off_share, half_float_bound.off_share);
        EXPECT_LE(c.block, half_float_bound.block);
        expect_validation_clean(*device_);
    }
}

TEST_F(SwiftShader, DecalsAgreeWithTheReference) {
    DecalGarden garden;
    garden.add_lights(5, 5, 6);
    for (const char* renderer : {"light-prepass", "deferred", "z-prepass"}) {
        Shot shot = garden.shot();
        shot.renderer = renderer;
        shot.width = 160, shot.height = 90;
        const Comparison c = against_reference(*device_, shot);
        EXPECT_GE(c.psnr, half_float_bound.psnr);
        // It filters textures in fewer bits: the middle of a highlight on the gold ball, whose roughness comes from
        // one.
        EXPECT_LE(c.off_share, 2 * half_float_bound.off_share);
        EXPECT_LE(c.block, half_float_bound.block);
        expect_validation_clean(*device_);
    }
}

} // namespace
} // namespace prelight
