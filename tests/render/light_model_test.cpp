// Every form of the lighting model, and what lights and cameras can be, against the reference.
#include "garden.hpp"

namespace prelight {
namespace {

class Forms : public testing::TestWithParam<Form> {};

TEST_P(Forms, AgreeWithTheReference) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    garden.add_light({.kind = LightKind::directional, .intensity = 0.6f}, {0, 0, 0}, {-0.3, -1, -0.5});
    Shot shot = garden.shot();
    shot.shading = GetParam().shading;
    shot.settings = GetParam().settings;
    if (shot.shading == Shading::phong)
        shot.exposure = -2;
    expect_agrees(shot);
}
INSTANTIATE_TEST_SUITE_P(
    LightModel, Forms,
    testing::Values(Form{"ggx_weighted", Shading::ggx, {}}, Form{"ggx_nv", Shading::ggx, {{"model", "nv"}}},
                    Form{"ggx_mono", Shading::ggx, {{"light-buffer", "packed-rgba16f"}, {"model", "mono"}}},
                    Form{"ggx_ambient_light", Shading::ggx, {{"ambient", "light"}}}, Form{"phong", Shading::phong, {}},
                    Form{"phong_packed", Shading::phong, {{"light-buffer", "packed-rgba16f"}}},
                    Form{"phong_step_gate", Shading::phong, {{"specular-gate", "step"}}},
                    Form{"phong_reflection", Shading::phong, {{"specular-vector", "reflection"}}},
                    Form{"phong_ambient_light", Shading::phong, {{"ambient", "light"}}}),
    [](const auto& form) { return std::string(form.param.name); });

class BacklitForms : public testing::TestWithParam<Form> {};

TEST_P(BacklitForms, AgreeWithTheReference) {
    BacklitGarden garden;
    Shot shot = garden.shot();
    shot.exposure = -1;
    shot.settings = GetParam().settings;
    expect_agrees(shot);
}
INSTANTIATE_TEST_SUITE_P(LightModel, BacklitForms,
                         testing::Values(Form{"weighted", Shading::ggx, {}},
                                         Form{"nv", Shading::ggx, {{"model", "nv"}}},
                                         Form{"mono", Shading::ggx, {{"light-buffer", "packed-rgba16f"}}}),
                         [](const auto& form) { return std::string(form.param.name); });

TEST(BacklitForm, WeightedIsNotAnyOtherForm) {
    BacklitGarden garden;
    const auto picture = [&](ReferenceForm::Fresnel fresnel) {
        return render_reference(garden.world, garden.camera, 160, 90, -1, {.fresnel = fresnel}).linear;
    };
    using Fresnel = ReferenceForm::Fresnel;
    EXPECT_LT(compare_pixels(picture(Fresnel::nv), picture(Fresnel::weighted)).psnr, 45);
    EXPECT_LT(compare_pixels(picture(Fresnel::mono), picture(Fresnel::weighted)).psnr, 45);
}

TEST(LightKinds, DirectionalAlone) {
    Garden garden;
    garden.add_light({.kind = LightKind::directional, .intensity = 2}, {0, 0, 0}, {0.4, -1, -0.6});
    expect_agrees(garden.shot());
}

TEST(LightKinds, PointWithoutRangeReachesEverything) {
    Garden garden;
    garden.add_light(garden.point(std::numeric_limits<float>::infinity(), 40), {0, 4, 3});
    expect_agrees(garden.shot());
}

TEST(LightKinds, SpotWithoutRange) {
    Garden garden;
    garden.add_light(garden.spot(0.5f, std::numeric_limits<float>::infinity(), 80), {2, 5, 3}, {-0.3, -1, -0.5});
    expect_agrees(garden.shot());
}

TEST(LightKinds, SeedFalloffs) {
    Garden garden;
    for (const Falloff falloff : {Falloff::linear, Falloff::quadratic, Falloff::gltf}) {
        Light light = garden.point(5, falloff == Falloff::gltf ? 5.0f : 1.5f);
        light.falloff = falloff;
        garden.add_light(light, {3.0 * static_cast<int>(falloff) - 3, 2, 2});
    }
    expect_agrees(garden.shot());
}

TEST(LightKinds, LightShininessMultipliesTheMaterials) {
    Garden garden;
    Light light = garden.point(12, 30);
    light.shininess = 4;
    garden.add_light(light, {1, 4, 4});
    Shot shot = garden.shot();
    shot.shading = Shading::phong;
    shot.exposure = -2;
    expect_agrees(shot);
    // And it is seen at all: a sharper highlight is another picture.
    garden.world.lights[0].light.shininess = 1;
    const Image sharp = render_reference(garden.world, shot.camera, 96, 54, -2, form_of(shot)).linear;
    garden.world.lights[0].light.shininess = 4;
    const Image soft = render_reference(garden.world, shot.camera, 96, 54, -2, form_of(shot)).linear;
    EXPECT_LT(compare_pixels(sharp, soft).psnr, 50);
}

TEST(Cameras, DepthsFarBelowTheNearPlanesScale) {
    // Device depth of 1e-10 and less is still a surface.
    Garden garden;
    garden.add_lights(8, 4, 6);
    garden.camera.camera.znear = 1e-10;
    for (const char* position : {"ray", "matrix"}) {
        Shot shot = garden.shot();
        shot.settings = {{"position", position}};
        expect_agrees(shot);
    }
}

TEST(Cameras, FiniteFarPlane) {
    Garden garden;
    garden.add_lights(8, 4, 6);
    garden.camera.camera.zfar = 14;
    expect_agrees(garden.shot());
}

TEST(Cameras, Orthographic) {
    Garden garden;
    garden.add_lights(8, 4, 6);
    garden.camera.camera.kind = ProjectionKind::orthographic;
    garden.camera.camera.ymag = 3.5;
    garden.camera.camera.zfar = 30;
    for (const char* position : {"ray", "matrix"})
        for (const char* depth : {"attachment", "r32f"}) {
            Shot shot = garden.shot();
            shot.settings = {{"position", position}, {"depth", depth}};
            expect_agrees(shot);
        }
}

TEST(Cameras, TenKilometresFromTheOrigin) {
    Garden garden(glm::dvec3(10000.03, -3.7, -10000.77));
    garden.add_lights(12, 4, 6);
    expect_agrees(garden.shot());
}

} // namespace
} // namespace prelight
