#include "worlds.hpp"
#include <gtest/gtest.h>

namespace prelight {
namespace {

using Fresnel = ReferenceForm::Fresnel;

void expect_near(glm::vec3 got, glm::dvec3 want, double relative, const char* what) {
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(static_cast<double>(got[channel]), want[channel], relative * std::abs(want[channel]) + 1e-12)
            << what << ", channel " << channel;
}

/// The configuration of by_hand.py: one pixel that looks at the origin of a plane.
struct OnePoint : TestWorld {
    PlacedCamera camera = look_at(Camera{}, {3, 0, 1}, {0, 0, 0}, {0, 0, 1});
    explicit OnePoint(bool with_lights = true) {
        add_material({.base_colour = {0.8f, 0.4f, 0.2f, 1}, .metallic = 0.3f, .roughness = 0.4f});
        add(square(4));
        if (!with_lights)
            return;
        add_light({.colour = {1, 0.8f, 0.6f}, .intensity = 10, .range = 5, .shininess = 0.02f}, {0.5, 1, 1.5});
        add_light({.colour = {0.2f, 0.5f, 1}, .intensity = 6, .shininess = 0.01f}, {-1.2, -0.4, 0.8});
    }
    glm::vec3 colour(const ReferenceForm& form, double exposure = 0) const {
        return render_reference(world, camera, 1, 1, exposure, form).linear.at(0, 0);
    }
};

TEST(Lighting, EveryFresnelFormByHand) {
    const OnePoint test;
    const auto expect = [&](Fresnel form, glm::dvec3 want, const char* what) {
        expect_near(test.colour({.fresnel = form}), want, 1e-6, what);
    };
    expect(Fresnel::full, {0.393980089, 0.275918011, 0.227604531}, "full");
    expect(Fresnel::weighted, {0.392499657, 0.275949076, 0.226717528}, "weighted");
    expect(Fresnel::nv, {0.364350906, 0.291782593, 0.296307153}, "nv");
    expect(Fresnel::mono, {0.450017868, 0.285569962, 0.196513441}, "mono");
}

TEST(Lighting, WaysOfAMaterialsOwnShininessByHand) {
    OnePoint test;
    test.world.ambient = {0.1f, 0.2f, 0.3f};
    const auto expect = [&](ReferenceForm::Specular way, glm::dvec3 want, const char* what, double exposure = 0) {
        expect_near(test.colour({.shading = Shading::phong, .ambient_as_light = true, .specular = way}, exposure),
                    want * std::exp2(exposure), 1e-6, what);
    };
    using Specular = ReferenceForm::Specular;
    expect(Specular::luminance, {1.476085264, 0.760644632, 0.431765225}, "luminance");
    expect(Specular::luv, {1.476085264, 0.760644632, 0.431765225}, "luv");
    expect(Specular::fifth_channel, {1.884998748, 0.986462527, 0.566035324}, "fifth channel");
    // The bent rule's base is what the light buffer holds: its shape depends on the exposure.
    expect(Specular::bent, {1.753272890, 0.913718396, 0.522782057}, "bent", -1.35);
}

TEST(Lighting, AmbientAsMaterialTermAndAsLight) {
    OnePoint test;
    test.world.ambient = {0.1f, 0.2f, 0.3f};
    const auto expect = [&](Fresnel form, glm::dvec3 want, const char* what) {
        expect_near(test.colour({.fresnel = form, .ambient_as_light = true}), want, 1e-6, what);
    };
    expect(Fresnel::full, {0.434972089, 0.323630011, 0.265908531}, "full");
    expect(Fresnel::weighted, {0.433869098, 0.323620678, 0.264889531}, "weighted");
    expect(Fresnel::nv, {0.399215785, 0.332363026, 0.328885811}, "nv");
    OnePoint dark(false);
    dark.world.ambient = {0.1f, 0.2f, 0.3f};
    for (const Shading shading : {Shading::ggx, Shading::phong})
        expect_near(dark.colour({.shading = shading}), {0.0828, 0.0856, 0.0684}, 1e-6, "material");
    expect_near(dark.colour({.shading = Shading::phong, .ambient_as_light = true}), {0.056, 0.056, 0.042}, 1e-6,
                "phong, light");
}

TEST(Lighting, PhongFormsByHand) {
    const OnePoint test;
    const auto expect = [&](bool step, bool reflection, bool mono, glm::dvec3 want) {
        expect_near(test.colour({.shading = Shading::phong,
                                 .mono_specular = mono,
                                 .gate_by_step = step,
                                 .reflection_vector = reflection}),
                    want, 1e-6, "phong");
    };
    expect(false, false, false, {1.799334908, 0.940776719, 0.570106882});
    expect(false, false, true, {1.846180340, 0.939950869, 0.529677041});
    expect(false, true, false, {1.490664692, 0.803758417, 0.508293055});
    expect(false, true, true, {1.589514024, 0.798209769, 0.445398549});
    expect(true, false, false, {1.939296587, 1.062528712, 0.689892543});
    expect(true, false, true, {2.059954902, 1.058005477, 0.599871673});
    expect(true, true, false, {1.553885047, 0.891040250, 0.612087667});
    expect(true, true, true, {1.738815214, 0.880659679, 0.494422820});
}

// Ambient light, being the material's own, keeps its colour.
TEST(Lighting, GreyReflectanceByHand) {
    OnePoint test;
    expect_near(test.colour({.fresnel = Fresnel::full, .grey_reflectance = true}),
                {0.417362315, 0.280750827, 0.286801430}, 1e-6, "full");
    expect_near(test.colour({.shading = Shading::phong, .grey_reflectance = true}),
                {1.658749395, 0.974728656, 0.737083484}, 1e-6, "phong");
    OnePoint dark(false);
    dark.world.ambient = {0.1f, 0.2f, 0.3f};
    expect_near(dark.colour({.grey_reflectance = true}), {0.0828, 0.0856, 0.0684}, 1e-6, "ambient");
}

TEST(Lighting, OneLightMakesWeightedExact) {
    OnePoint test;
    test.world.lights.pop_back();
    expect_near(test.colour({.fresnel = Fresnel::weighted}), glm::dvec3(test.colour({.fresnel = Fresnel::full})), 1e-6,
                "one light");
}

// measure.md: a plane under a light matches the closed form within 0.1 %. With a smooth dielectric
// the highlight is a small spot; outside it only Lambert's term is left.
TEST(Lighting, PlaneUnderOneLightIsTheClosedForm) {
    TestWorld test;
    test.add_material({.base_colour = {0.5f, 0.6f, 0.7f, 1}, .metallic = 0, .roughness = 0});
    test.add(square(10));
    const double height = 1.5, range = 9, intensity = 20;
    test.add_light({.intensity = float(intensity), .range = float(range)}, {3, 1, height});
    const uint32_t width = 64, rows = 36;
    const PlacedCamera camera = front_camera(8);
    const ReferenceForm form{.shading = Shading::phong};
    const auto picture = render_reference(test.world, camera, width, rows, 0, form);
    uint32_t in_highlight = 0;
    for (uint32_t y = 0; y < rows; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::dvec3 p = on_plane(8, 0.8, x, y, width, rows);
            const double r2 = (p.x - 3) * (p.x - 3) + (p.y - 1) * (p.y - 1), d2 = r2 + height * height;
            const double share = d2 / (range * range);
            const double want = intensity * height / std::pow(d2, 1.5) * std::max(0.0, 1 - share * share);
            const double got = double(picture.linear.at(x, y).r) / 0.5;
            if (got > want * 1.001) {
                ++in_highlight;
                continue;
            }
            EXPECT_NEAR(got, want, 1e-3 * want) << x << ", " << y;
            EXPECT_NEAR(double(picture.linear.at(x, y).b) / 0.7, want, 1e-3 * want);
        }
    EXPECT_LT(in_highlight, 5u);
}

TEST(Lighting, DirectionalAndExposure) {
    TestWorld test;
    test.add_material({.base_colour = glm::vec4(1), .metallic = 0, .roughness = 0});
    test.add(square(10));
    // 60° from the normal: N·L = 0.5, 3 lux.
    test.add_light({.kind = LightKind::directional, .colour = {1, 0.5f, 0.25f}, .intensity = 3}, {1000, 1000, -1000},
                   {std::sqrt(3.0), 0, -1});
    const ReferenceForm form{.shading = Shading::phong};
    const auto picture = render_reference(test.world, front_camera(4), 16, 9, 2, form);
    for (const glm::vec3& pixel : picture.linear.pixels)
        expect_near(pixel, {6, 3, 1.5}, 1e-4, "2 EV: four times");
}

TEST(Lighting, SpotConeFromInnerToOuterEdge) {
    TestWorld test;
    test.add_material({.metallic = 0, .roughness = 0});
    test.add(square(10));
    const double inner = 0.3, outer = 0.5, height = 2;
    test.add_light({.kind = LightKind::spot, .intensity = 5, .inner_cone = float(inner), .outer_cone = float(outer)},
                   {0, 0, height}, {0, 0, -1});
    const ReferenceForm form{.shading = Shading::phong};
    const uint32_t width = 101, rows = 3;
    // A strip of 4 m across the cone's axis.
    const double yfov = 0.0396;
    const auto picture = render_reference(test.world, front_camera(3, yfov), width, rows, 0, form);
    uint32_t inside = 0, between = 0, outside = 0;
    for (uint32_t x = 0; x < width; ++x) {
        const glm::dvec3 p = on_plane(3, yfov, x, 1, width, rows);
        const double theta = std::atan2(std::abs(p.x), height);
        const double d2 = p.x * p.x + height * height;
        const double lambert = 5 * height / std::pow(d2, 1.5);
        const double cone =
            std::clamp((std::cos(theta) - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 0.0, 1.0);
        const double got = double(picture.linear.at(x, 1).g);
        if (std::abs(p.x) < 0.1)
            continue; // the highlight
        EXPECT_NEAR(got, lambert * cone * cone, 1e-3 * lambert) << "pixel " << x;
        ++(theta < inner ? inside : theta < outer ? between : outside);
        if (theta > outer + 1e-6) {
            EXPECT_EQ(got, 0);
        }
    }
    EXPECT_GT(inside, 10u);
    EXPECT_GT(between, 4u);
    EXPECT_GT(outside, 10u);
}

TEST(Lighting, FalloffsByHand) {
    const auto at = [](Falloff falloff, double distance) {
        TestWorld test;
        test.add_material({.metallic = 0, .roughness = 0});
        test.add(square(1));
        test.add_light({.intensity = 1, .range = 4, .falloff = falloff}, {0, 0, distance});
        // Seen from the side: the mirror image is elsewhere.
        const PlacedCamera camera = look_at(Camera{}, {2, 0, 1}, {0, 0, 0}, {0, 0, 1});
        const ReferenceForm form{.shading = Shading::phong};
        return double(render_reference(test.world, camera, 1, 1, 0, form).linear.at(0, 0).r);
    };
    EXPECT_NEAR(at(Falloff::gltf, 2), (1 - 1 / 16.0) / 4, 1e-6);
    EXPECT_NEAR(at(Falloff::gltf, 0.001), 1e4, 1e-1); // d counts as 1 cm
    EXPECT_NEAR(at(Falloff::linear, 1), 0.75, 1e-6);
    EXPECT_NEAR(at(Falloff::linear, 3), 0.25, 1e-6);
    EXPECT_NEAR(at(Falloff::quadratic, 1), 0.9375, 1e-6);
    EXPECT_NEAR(at(Falloff::quadratic, 3), 0.4375, 1e-6);
    for (const Falloff falloff : {Falloff::gltf, Falloff::linear, Falloff::quadratic})
        EXPECT_EQ(at(falloff, 4.001), 0);
}

TEST(Lighting, EmissiveOcclusionAndUnlit) {
    OnePoint test(false);
    test.world.ambient = glm::vec3(1);
    Material& material = test.scene.materials[0];
    material.emissive = {3, 2, 1};
    material.occlusion_texture.image = test.add_image(1, 1, {51, 255, 255, 255}); // 0.2
    material.occlusion_strength = 0.5f;                                           // → 0.6
    const glm::dvec3 term = glm::dvec3(0.828, 0.428, 0.228);
    expect_near(test.colour({}), 0.6 * term + glm::dvec3(3, 2, 1), 1e-6, "occluded");
    // As a light ambient is not occluded.
    expect_near(test.colour({.shading = Shading::phong, .ambient_as_light = true}),
                glm::dvec3(0.56 + 3, 0.28 + 2, 0.14 + 1), 1e-6, "as light");
    material.unlit = true;
    expect_near(test.colour({}), {0.8, 0.4, 0.2}, 1e-6, "unlit");
    expect_near(test.colour({}, 1), {1.6, 0.8, 0.4}, 1e-6, "unlit, exposed");
}

TEST(Lighting, LightsBehindTheSurfaceGiveNothing) {
    TestWorld test;
    test.add(square(1));
    test.add_light({.intensity = 100}, {0, 0, -1});
    test.add_light({.intensity = 100}, {3, 0, 0}); // in the plane
    for (const Shading shading : {Shading::ggx, Shading::phong}) {
        const ReferenceForm form{.shading = shading, .gate_by_step = true};
        const auto picture = render_reference(test.world, front_camera(2), 8, 8, 0, form);
        EXPECT_EQ(picture.linear.at(4, 4), glm::vec3(0));
    }
}

} // namespace
} // namespace prelight
