// Several samples a pixel with everything else that changes what a pixel shows, in each architecture against the
// reference's form of it.
#include "decal_world.hpp"
#include "every_way.hpp"
#include "garden.hpp"
#include <algorithm>
#include <cmath>
#include <prelight/material_shader.hpp>
#include <scene/procedural/cookie_maps.hpp>
#include <vulkan/vulkan_core.h>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;

const Way architectures[] = {{"light-prepass", {}}, {"deferred", {}}, {"z-prepass", {}}, {"multipass", {}}};

constexpr EdgeBound few_edges{.pixels = 400};
/// Of a shot in each of several ways; those that light samples by themselves at all samples and at edges alone.
void expect_agree(const Shot& shot, std::span<const Way> ways = architectures, const Bound& bound = half_float_bound,
                  const EdgeBound& edges = few_edges) {
    References references;
    const auto expect = [&](const Shot& one) {
        SCOPED_TRACE(name_of(one));
        const Image picture = render_linear(test_device(), one);
        if (one.settings.count("msaa-light") && one.settings.at("msaa-light") == "edges")
            save_when_wanted(picture, references.of(one));
        expect_within_on_edges(picture, references.of(one), bound, edges);
        expect_validation_clean(test_device());
    };
    for (const Way& way : ways) {
        Shot one = in_way(shot, way);
        if (one.renderer == "light-prepass" || one.renderer == "deferred") {
            one.settings["msaa-light"] = "edges";
            expect(one);
            one.settings["msaa-light"] = "samples";
        }
        expect(one);
    }
}

// The default device's coverage is that after the depth test; without it fragments compare depths.
TEST(SamplesWith, CoverageBeforeTheDepthTestAlone) {
    const auto device = Device::create(
        {.select = "cpu", .validate = true, .hidden_extensions = {VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME}});
    Garden garden;
    garden.add_lights(8, 4, 6);
    Shot shot = in_way(with_samples(garden.shot()), {"light-prepass", {{"msaa-light", "edges"}}});
    References references;
    const Image picture = render_linear(*device, shot);
    expect_within_on_edges(picture, references.of(shot), half_float_bound, few_edges);
    expect_validation_clean(*device);
    const Image after = render_linear(test_device(), shot);
    size_t apart = 0;
    for (size_t i = 0; i < picture.pixels.size(); ++i) {
        const glm::vec3 off = glm::abs(picture.pixels[i] - after.pixels[i]);
        apart += std::max({off.x, off.y, off.z}) > 0.01f ? 1 : 0;
    }
    EXPECT_LT(apart, picture.pixels.size() / 1000) << "the two ways find the same samples";
}

TEST(SamplesWith, Shadows) {
    Garden garden;
    garden.add_light({.kind = LightKind::directional, .colour = {1, 0.9f, 0.8f}, .intensity = 0.8f}, garden.at(0, 5, 0),
                     glm::normalize(glm::dvec3(-0.5, -1, -0.3)));
    garden.add_light(garden.spot(0.6f, 12, 40), garden.at(4, 5, 3), glm::normalize(glm::dvec3(-0.7, -1, -0.6)));
    Shot shot = with_samples(garden.shot(), 192);
    shot.settings = {
        {"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}, {"shadow-budget", "8388608"}};
    const Way ways[] = {
        {"light-prepass", {}}, {"light-prepass", {{"light-culling", "volumes"}}}, {"deferred", {}}, {"multipass", {}}};
    expect_agree(shot, ways, half_float_bound, {.pixels = 200});
}

/// Balls and cards in and out of each other's shadows.
struct ShadowedGarden : Garden {
    ShadowedGarden() {
        for (int i = 0; i < 3; ++i) {
            const glm::dmat4 place = glm::translate(glm::dmat4(1), {-3.0 + 3 * i, 0.9, i % 2 ? -1.4 : 1.5});
            add(square(0.8f), glm::rotate(place, 0.8 * i - 0.8, glm::dvec3(0.1, 1, 0.3)));
        }
        add_light({.kind = LightKind::directional, .colour = {1, 0.9f, 0.8f}, .intensity = 0.8f}, at(0, 5, 0),
                  glm::normalize(glm::dvec3(-0.5, -1, -0.3)));
        add_light(spot(0.6f, 12, 40), at(4, 5, 3), glm::normalize(glm::dvec3(-0.7, -1, -0.6)));
    }
};

constexpr std::pair<const char*, const char*> sharp_shadows[] = {
    {"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-detail", "8"}, {"shadow-budget", "8388608"}};

TEST(SamplesWith, ShadowsOncePerPixel) {
    const ShadowedGarden garden;
    Shot shot = with_samples(garden.shot(), 320);
    shot.settings.insert(std::begin(sharp_shadows), std::end(sharp_shadows));
    const Way ways[] = {{"light-prepass", {}},
                        {"light-prepass", {{"msaa-light", "samples"}}},
                        {"light-prepass", {{"list-shading", "fragment"}, {"normals", "oct32"}}},
                        {"light-prepass", {{"light-culling", "volumes"}, {"position", "matrix"}}},
                        {"deferred", {}},
                        {"deferred", {{"msaa-light", "samples"}, {"light-culling", "clusters"}}}};
    for (const bool orthographic : {false, true}) {
        if (orthographic) {
            shot.camera.camera.kind = ProjectionKind::orthographic;
            shot.camera.camera.ymag = 2.8;
            shot.camera.camera.zfar = 40;
        }
        References references;
        for (const Way& way : std::span(ways).first(orthographic ? 1 : std::size(ways))) {
            Shot one = in_way(shot, way);
            SCOPED_TRACE(name_of(one));
            const Image each = &way == ways ? render_linear(test_device(), one) : Image();
            one.settings["msaa-shadows"] = "pixel";
            const ReferencePicture& reference = references.of(one);
            const Image once = render_linear(test_device(), one);
            save_when_wanted(once, reference);
            expect_within_on_edges(once, reference, half_float_bound, {.pixels = 200});
            if (&way != ways)
                continue;
            // Pixels that are judged tell the two apart.
            EXPECT_GT(compare_pixels(once, reference.linear, reference.left_out()).psnr,
                      compare_pixels(each, reference.linear, reference.left_out()).psnr + 3);
        }
    }
    expect_validation_clean(test_device());
}

TEST(SamplesWith, CookiesAndProfiles) {
    Garden garden;
    garden.scene.images = {window_cookie(), dice_cookie()};
    Light window = garden.spot(0.6f, 14, 70), dice = garden.point(8, 8), lamp = garden.point(9, 8);
    window.cookie = 0, dice.cookie = 1;
    lamp.profile = wall_lamp();
    garden.add_light(window, {3, 5.5, 4}, {-0.5, -1, -0.7});
    garden.add_light(dice, {2.2, 2.6, -1}, {-0.6, 0.2, -1});
    garden.add_light(lamp, {-4, 3, -2}, {0.3, -1, 0.2});
    const Way ways[] = {{"light-prepass", {}},
                        {"light-prepass", {{"list-shading", "fragment"}}},
                        {"deferred", {}},
                        {"z-prepass", {}},
                        {"multipass", {}}};
    expect_agree(with_samples(garden.shot()), ways);
}

// What a decal reaches is drawn once a sample, whatever the settings say, for the decals' buffer holds samples: here
// that is everything. On cards, for decals see the normal that was stored, and that is a fragment's. Orthographic, for
// lavapipe (Mesa 22.3) divides by w at the pixel's centre.
TEST(SamplesWith, DecalsOnEachSample) {
    DecalGarden garden;
    garden.world.instances.resize(1); // the floor
    for (int i = 0; i < 5; ++i) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), {-4.0 + 2 * i, 1, i % 2 ? -1.2 : 0.8});
        m = glm::rotate(m, 0.3 * i - 0.7, glm::dvec3(0.2, 1, 0.1));
        garden.add(square(1), glm::rotate(m, 0.2 * i, glm::dvec3(0, 0, 1)));
    }
    garden.add_lights(6, 5, 6);
    Decal over{.material = garden.painted, .opacity = 0.2f};
    over.order = 9;
    garden.add_decal(over, {0, 0.5, 0}, garden.camera.axes[2], 0.1, {22, 22, 22});
    Shot shot = with_samples(garden.shot());
    shot.camera.camera.kind = ProjectionKind::orthographic;
    shot.camera.camera.ymag = 3;
    shot.camera.camera.zfar = 40;
    const Way ways[] = {{"light-prepass", {{"msaa-light", "samples"}}},
                        {"light-prepass", {{"msaa-light", "samples"}, {"normals", "oct32"}}},
                        {"deferred", {{"msaa-light", "samples"}}},
                        {"z-prepass", {}},
                        {"z-prepass", {{"lights", "grid"}}},
                        {"multipass", {}}};
    for (const Way& way : ways) {
        const Shot one = in_way(shot, way);
        SCOPED_TRACE(name_of(one));
        ReferenceForm form = form_of(one);
        form.samples = {.count = 4};
        const ReferencePicture reference =
            render_reference(garden.world, one.camera, one.width, one.height, one.exposure, form);
        const Image picture = render_linear(test_device(), one);
        save_when_wanted(picture, reference);
        expect_within_on_edges(picture, reference, half_float_bound, {.pixels = 300});
    }
    expect_validation_clean(test_device());
}

TEST(SamplesWith, AnEnvironmentAndItsBackground) {
    Garden garden;
    auto sky = std::make_shared<Environment>(Environment{.name = "sky", .image = Image(48, 24)});
    for (uint32_t y = 0; y < 24; ++y)
        for (uint32_t x = 0; x < 48; ++x)
            sky->image.at(x, y) = glm::mix(glm::vec3(0.2f, 0.4f, 1), glm::vec3(0.3f, 0.2f, 0.1f),
                                           (static_cast<float>(y) + 3 * std::sin(0.26f * static_cast<float>(x))) / 24);
    for (glm::vec3& texel : sky->image.pixels)
        texel = glm::max(texel, glm::vec3(0));
    garden.scene.environment = sky;
    garden.add_lights(4, 5, 4);
    const Way ways[] = {{"light-prepass", {}}, {"deferred", {}}, {"z-prepass", {}}, {"multipass", {}}};
    expect_agree(with_samples(garden.shot(), 112), ways, half_float_bound, {.pixels = 150});
}

TEST(SamplesWith, SpecularAntialiasingOff) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    Shot shot = with_samples(garden.shot());
    shot.settings = {{"specular-antialiasing", "off"}};
    expect_agree(shot);
}

TEST(SamplesWith, MaterialsOfTheirOwn) {
    for (const char* name : {"skin", "reflection", "fresnel-rim"}) {
        SCOPED_TRACE(name);
        const ShadedGarden garden(find_material_shader(name));
        expect_agree(with_samples(garden.shot()));
    }
}

TEST(SamplesWith, MasksUnlitSurfacesAndBothSides) {
    const MixedMaterials world;
    expect_agree(with_samples(world.shot()), architectures, half_float_bound, {.pixels = 100});
}

TEST(SamplesWith, ThePhongModel) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    Shot shot = with_samples(garden.shot());
    shot.shading = Shading::phong;
    const Way ways[] = {{"light-prepass", {}},
                        {"light-prepass", {{"light-buffer", "packed-rgba16f"}}},
                        {"light-prepass", {{"light-buffer", "packed-rgba16f"}, {"specular", "fifth-channel"}}},
                        {"deferred", {}},
                        {"z-prepass", {}},
                        {"multipass", {}}};
    expect_agree(shot, ways);
}

// Bounds of the formats, as tests of one sample have them.
TEST(SamplesWith, LightBuffersInFixedPoint) {
    const FewLights garden;
    Shot shot = with_samples(garden.shot());
    shot.exposure = 0.7;
    const auto buffer = [](const char* name, const char* writes) {
        return Way{"light-prepass",
                   {{"light-buffer", name},
                    {"light-writes", writes},
                    {"light-scale", std::string(writes) == "once" ? "8" : "2"}}};
    };
    const Bound coarse{.psnr = 37, .off_share = 1, .block = 255};
    const Way bytes[] = {buffer("rgba8", "blended"), buffer("rgba8", "once"), buffer("packed-rgba8", "once")};
    expect_agree(shot, bytes, coarse, {.pixels = 400, .psnr = 37});
    const Way ten[] = {buffer("rgb10a2", "blended"), buffer("rgb10a2", "once")};
    expect_agree(shot, ten, {.psnr = 48, .off_share = 1, .block = 255}, {.pixels = 400, .psnr = 45});
    const Way wide[] = {{"light-prepass", {{"light-sums", "float32"}}},
                        {"light-prepass", {{"light-writes", "once"}}},
                        {"light-prepass", {{"light-writes", "blended"}}},
                        {"light-prepass", {{"ambient", "light"}}}};
    expect_agree(shot, wide);
}

TEST(SamplesWith, EncodingsOfNormalsAndPositions) {
    Garden garden;
    garden.add_lights(12, 4, 6);
    const Way ways[] = {{"light-prepass", {{"normals", "oct32"}, {"normal-space", "view"}}},
                        {"light-prepass", {{"normals", "xy16f"}, {"normal-space", "view"}, {"position", "matrix"}}},
                        {"light-prepass", {{"normals", "rgb10a2"}, {"geometry", "two-passes"}}},
                        {"deferred", {{"position", "matrix"}}}};
    expect_agree(with_samples(garden.shot()), ways);
}

TEST(SamplesWith, EveryWayToFindLights) {
    Garden garden;
    garden.add_lights(20, 4, 6);
    garden.add_light(garden.spot(0.6f, 8, 20), garden.at(1, 4, 2), {0, -1, -0.2});
    garden.add_light({.kind = LightKind::directional, .intensity = 0.3f}, {0, 0, 0}, {-0.3, -1, -0.5});
    std::vector<Way> ways;
    for (const Shot& shot : every_way({}))
        ways.push_back({shot.renderer == "light-prepass" ? "light-prepass"
                        : shot.renderer == "deferred"    ? "deferred"
                        : shot.renderer == "z-prepass"   ? "z-prepass"
                                                         : "multipass",
                        shot.settings});
    expect_agree(with_samples(garden.shot(), 160), ways, half_float_bound, {.pixels = 200});
}

} // namespace
} // namespace prelight
