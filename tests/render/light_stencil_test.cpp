// Volumes mark in stencil the pixels they hold; and the forms of that the presets want.
#include "found_pixels.hpp"
#include <vulkan/vulkan_core.h>

namespace prelight {
namespace {

const SettingMap stencil{{"light-culling", "stencil"}};
const SettingMap stencil_boxes{{"light-culling", "stencil"}, {"spot-volume", "box"}};
const SettingMap boxes{{"light-culling", "volumes"}, {"spot-volume", "box"}};
const SettingMap untested{{"light-culling", "volumes"}, {"volume-depth-test", "off"}};
const SettingMap untested_boxes{{"light-culling", "volumes"}, {"volume-depth-test", "off"}, {"spot-volume", "box"}};

bool is_spot_of_less_than_80_degrees(const Light& light) {
    return light.kind == LightKind::spot && light.outer_cone < 1.39;
}

class StencilMarks : public testing::TestWithParam<LightCase> {};

TEST_P(StencilMarks, FindTheirPixelsOnceFromOutsideInsideAndCutByTheNearPlane) {
    const LightFromEverywhere scene(GetParam().light, GetParam().direction);
    std::vector<SettingMap> settings{stencil};
    if (is_spot_of_less_than_80_degrees(GetParam().light))
        settings.push_back(stencil_boxes);
    expect_same_as_fullscreen(scene.garden.world, scene.cameras, settings);
}

TEST_P(StencilMarks, AgreeWithTheReferenceFromInside) {
    Garden garden;
    Light light = GetParam().light;
    light.range *= 3; // reaches floor and camera at once
    light.intensity *= 2;
    garden.add_light(light, garden.at(0.5, 3.8, 6.5), GetParam().direction);
    Shot shot = garden.shot();
    shot.settings = stencil;
    expect_agrees(shot);
}

TEST_P(StencilMarks, BoxesAndVolumesWithoutDepthTestFindTheSamePixels) {
    const LightFromEverywhere scene(GetParam().light, GetParam().direction);
    std::vector<SettingMap> settings{untested};
    if (is_spot_of_less_than_80_degrees(GetParam().light))
        settings.insert(settings.end(), {boxes, untested_boxes});
    expect_same_as_fullscreen(scene.garden.world, scene.cameras, settings);
}
INSTANTIATE_TEST_SUITE_P(All, StencilMarks, testing::ValuesIn(light_cases()),
                         [](const auto& form) { return std::string(form.param.name); });

TEST(StencilCulling, LightsEverywhereAndEveryProjection) {
    const LightsEverywhere scene;
    const SettingMap volumes{{"light-culling", "volumes"}};
    const auto found = expect_same_as_fullscreen(scene.garden.world, scene.cameras,
                                                 {{stencil, volumes, stencil_boxes, untested_boxes}});
    // Marks leave less than the depth test of one side, from everywhere.
    for (size_t i = 0; i < scene.cameras.size(); ++i)
        EXPECT_LT(found[0][i].evaluated, found[1][i].evaluated) << "camera " << i;
}

TEST(StencilCulling, MarksHoldThePixelsOfTheVolumeAndNoOthers) {
    // On a floor below the light every pixel within its range is lit. The sphere's mesh lies between 1
    // and 1.08 ranges, so what is evaluated lies between what two lights of these ranges light.
    TestWorld small, large;
    std::vector<PlacedCamera> cameras;
    for (TestWorld* world : {&small, &large}) {
        world->add_material({.name = "floor"});
        world->add(square(40), glm::rotate(glm::dmat4(1), -1.5707963267948966, glm::dvec3(1, 0, 0)));
    }
    small.add_light({.kind = LightKind::point, .intensity = 4, .range = 3}, {0, 1, 0});
    large.add_light({.kind = LightKind::point, .intensity = 4, .range = 3 * 1.08f}, {0, 1, 0});
    Camera lens;
    lens.znear = 0.3;
    for (const glm::dvec3& eye :
         {glm::dvec3(0, 4, 9), glm::dvec3(0, 2.2, 2.85), glm::dvec3(0, 1.5, 1), glm::dvec3(0, 0.3, 3.2)})
        cameras.push_back(look_at(lens, eye, {0, 0, -1}));
    const SettingMap fullscreen{{"light-culling", "fullscreen"}};
    const auto marked = find_pixels(small.world, cameras, stencil);
    const auto least = find_pixels(small.world, cameras, fullscreen),
               most = find_pixels(large.world, cameras, fullscreen);
    for (size_t i = 0; i < cameras.size(); ++i) {
        EXPECT_GT(least[i].contributing, 1000u);
        EXPECT_GE(marked[i].evaluated, least[i].contributing) << "camera " << i;
        EXPECT_LE(marked[i].evaluated, most[i].contributing) << "camera " << i;
    }
}

TEST(StencilCulling, EachLightLeavesAnEmptyStencil) {
    // Lights that overlap evaluate together what they evaluate alone: no mark is left for the next.
    Garden both, one[2];
    const glm::dvec3 places[] = {{-0.5, 1.2, 0.5}, {0.4, 0.8, 0}};
    for (int i = 0; i < 2; ++i)
        for (Garden* garden : {&both, &one[i]})
            garden->add_light(garden->point(3, 5), places[i]);
    for (int i = 0; i < 300; ++i) // more than a stencil counts to
        both.add_light(both.point(3, 0.01f), places[i % 2]);
    const std::vector<PlacedCamera> cameras{both.camera};
    const uint64_t alone[] = {find_pixels(one[0].world, cameras, stencil)[0].evaluated,
                              find_pixels(one[1].world, cameras, stencil)[0].evaluated};
    EXPECT_EQ(find_pixels(both.world, cameras, stencil)[0].evaluated, 151 * (alone[0] + alone[1]));
    expect_validation_clean(test_device());
}

TEST(StencilCulling, ManyLightsAgreeWithTheReference) {
    LightsEverywhere scene;
    scene.garden.add_light({.kind = LightKind::directional, .intensity = 0.3f}, {0, 0, 0}, {-0.3, -1, -0.5});
    for (const SettingMap& settings : {stencil, untested_boxes}) {
        Shot shot = scene.garden.shot();
        shot.settings = settings;
        expect_agrees(shot);
    }
}

TEST(StencilCulling, SwiftShaderFindsTheSamePixels) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    LightsEverywhere scene;
    scene.cameras.resize(3);
    expect_same_as_fullscreen(scene.garden.world, scene.cameras, {{stencil, untested_boxes}}, *device);
}

TEST(StencilFormat, TheNextFormatIsTakenAndNamed) {
    const auto device =
        Device::create({.select = "cpu", .validate = true, .hidden_formats = {VK_FORMAT_D32_SFLOAT_S8_UINT}});
    Garden garden;
    garden.add_lights(12, 4, 6);
    Shot shot = garden.shot();
    shot.settings = stencil;
    const Comparison c = against_reference(*device, shot);
    EXPECT_GE(c.psnr, half_float_bound.psnr);
    EXPECT_LE(c.block, half_float_bound.block);
    const auto renderer =
        create_renderer("light-prepass", device.get(), {.width = 16, .height = 16, .settings = stencil});
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    EXPECT_THAT(renderer->stats().notes, testing::ElementsAre(testing::HasSubstr("D24_S8 is taken")));
    expect_validation_clean(*device);
}

TEST(StencilFormat, ADeviceWithoutStencilIsRefused) {
    const auto device = Device::create(
        {.select = "cpu", .hidden_formats = {VK_FORMAT_D32_SFLOAT_S8_UINT, VK_FORMAT_D24_UNORM_S8_UINT}});
    Garden garden;
    garden.add_lights(1, 5, 5); // without any, nothing is drawn that needs stencil
    const auto renderer =
        create_renderer("light-prepass", device.get(), {.width = 16, .height = 16, .settings = stencil});
    EXPECT_THROW(renderer->set_world(garden.world), std::runtime_error);
}

} // namespace
} // namespace prelight
