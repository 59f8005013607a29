// Alpha masks keep their coverage at any distance: in their mip maps, and in pictures whose mean is the reference's,
// which looks at level 0 alone.
#include "against_reference.hpp"
#include <cmath>
#include <filesystem>
#include <numeric>
#include <prelight/scene_io.hpp>
#include <reference/worlds.hpp>
#include <resident/mask_levels.hpp>

namespace prelight {
namespace {

using resident::mask_coverage;
using resident::mask_levels;

template <class Alpha>
std::vector<uint8_t> white_texels(uint32_t size, Alpha alpha) {
    std::vector<uint8_t> rgba;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x)
            rgba.insert(rgba.end(),
                        {255, 255, 255, static_cast<uint8_t>(std::lround(255 * std::clamp(alpha(x, y), 0.0f, 1.0f)))});
    return rgba;
}

struct Pattern {
    const char* name;
    float (*alpha)(uint32_t x, uint32_t y);
};
float noise(uint32_t x, uint32_t y) {
    uint32_t h = x * 0x9e3779b9u ^ y * 0x85ebca6bu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.0f;
}
const Pattern patterns[]{
    {"a quarter of the texels", [](uint32_t x, uint32_t y) { return noise(x, y) < 0.25f ? 1.0f : 0.0f; }},
    {"leaves",
     [](uint32_t x, uint32_t y) {
         const float u = static_cast<float>(x) / 128 * 6.2831853f, v = static_cast<float>(y) / 128 * 6.2831853f;
         return 0.35f + 0.4f * std::sin(3 * u + 2 * std::sin(2 * v)) * std::sin(5 * v) + 0.3f * noise(x / 4, y / 4);
     }},
    {"a fence", [](uint32_t x, uint32_t) { return x % 16 < 5 ? 1.0f : 0.0f; }},
    {"every fourth texel", [](uint32_t x, uint32_t y) { return (x | y) % 2 == 0 ? 1.0f : 0.0f; }}};

TEST(MaskLevels, KeepTheCoverageOfLevelNought) {
    for (const Pattern& pattern : patterns)
        for (const float cutoff : {0.2f, 0.5f, 0.8f}) {
            SCOPED_TRACE(std::string(pattern.name) + ", " + std::to_string(cutoff));
            const TextureImage image{"mask", 128, 128, white_texels(128, pattern.alpha)};
            const double wanted = mask_coverage(image, cutoff, {}, Filter::linear);
            const auto levels = mask_levels(image, cutoff, {});
            for (const TextureImage& level : levels)
                EXPECT_NEAR(mask_coverage(level, cutoff, {}, Filter::linear), wanted, std::max(0.1 * wanted, 0.002))
                    << level.width;
        }
    const TextureImage quarter{"mask", 128, 128, white_texels(128, patterns[0].alpha)};
    EXPECT_GE(mask_levels(quarter, 0.5f, {}).size(), 5u) << "levels are there to be used";
}

TEST(MaskLevels, KeepColoursAndWholePictures) {
    TextureImage image{"mask", 4, 2, std::vector<uint8_t>(32, 255)};
    for (size_t i = 0; i < 32; i += 8)
        image.rgba[i] = image.rgba[i + 1] = image.rgba[i + 2] = 0; // every second one black
    const auto levels = mask_levels(image, 0.5f, {});
    ASSERT_EQ(levels.size(), 3u);
    for (size_t l = 1; l < levels.size(); ++l)
        for (size_t i = 0; i < levels[l].rgba.size(); ++i)
            EXPECT_NEAR(levels[l].rgba[i], i % 4 == 3 ? 255 : 188, 1) << "the mean of light, not of codes";
}

double mean(const Image& image) {
    double sum = 0;
    for (const glm::vec3& p : image.pixels)
        sum += static_cast<double>(p.g);
    return sum / static_cast<double>(image.pixels.size());
}

double reference_mean(const Shot& shot) {
    return mean(
        render_reference(*shot.world, shot.camera, shot.width, shot.height, shot.exposure, form_of(shot)).linear);
}

/// White masked squares, unlit, that a camera sees from farther and farther away.
struct MaskedWall : TestWorld {
    explicit MaskedWall(const Pattern& pattern, float cutoff = 0.5f, float factor = 1, float vertex_alpha = 1) {
        const uint32_t image = add_image(128, 128, white_texels(128, pattern.alpha));
        Material material{.name = "mask",
                          .base_colour = {1, 1, 1, factor},
                          .alpha_mode = AlphaMode::mask,
                          .alpha_cutoff = cutoff,
                          .unlit = true};
        material.base_colour_texture = {.image = image};
        add_material(material);
        Primitive p = square(1);
        if (vertex_alpha < 1)
            p.colours.assign(4, {1, 1, 1, vertex_alpha});
        scene.meshes.push_back({"mesh", {p}});
        for (int i = 0; i < 24 * 24; ++i) // each on its own place among the pixels
            place(0, glm::translate(glm::dmat4(1), {2.237 * (i % 24 - 12), 2.171 * (i / 24 - 12), 0}));
    }
    /// `side`: of a square, in pixels.
    Shot shot(double side, const std::string& renderer) const {
        Camera lens;
        lens.kind = ProjectionKind::orthographic;
        lens.ymag = 128 / side;
        lens.znear = 1;
        lens.zfar = 100;
        return {.world = &world,
                .camera = look_at(lens, {0, 0, 10}, {0, 0, 0}),
                .width = 128,
                .height = 128,
                .settings = {{"texture-filter", "auto"}},
                .renderer = renderer};
    }
};

void expect_coverage(const MaskedWall& wall, const std::vector<std::string>& names, double nearest = 0) {
    for (const double side : {60.0, 40.0, 33.0, 26.0, 19.0, 13.0, 9.0, 6.0}) {
        if (side < nearest)
            continue;
        const double right = reference_mean(wall.shot(side, names[0]));
        for (const std::string& renderer : names)
            EXPECT_NEAR(mean(render_linear(test_device(), wall.shot(side, renderer))), right, 0.12 * right)
                << side << " pixels, " << renderer;
    }
}

TEST(MaskCoverage, StaysAtADistance) {
    expect_coverage(MaskedWall(patterns[0]), device_renderers);
    expect_coverage(MaskedWall(patterns[1]), {"light-prepass"});
    expect_coverage(MaskedWall(patterns[2]), {"light-prepass"},
                    19); // farther away rays make a pattern of their own of it
    expect_validation_clean(test_device());
}

TEST(MaskCoverage, KnowsWhatTheTexturesAlphaIsMultipliedBy) {
    expect_coverage(MaskedWall(patterns[1], 0.25f, 0.5f), {"light-prepass"});
    expect_coverage(MaskedWall(patterns[1], 0.4f, 1, 0.8f), {"light-prepass"});
}

TEST(MaskCoverage, OneTextureServesTwoCutoffs) {
    MaskedWall wall(patterns[1], 0.3f), other(patterns[1], 0.7f), both(patterns[1], 0.3f);
    Material second = both.scene.materials[0];
    second.alpha_cutoff = 0.7f;
    both.add_material(second);
    Mesh copy = both.scene.meshes[0];
    copy.primitives[0].material = 1;
    both.scene.meshes.push_back(copy);
    std::vector<Instance> even, odd;
    for (size_t i = 0; i < both.world.instances.size(); ++i) {
        both.world.instances[i].mesh = i % 2;
        (i % 2 ? odd : even).push_back(wall.world.instances[i]);
    }
    wall.world.instances = even;
    other.world.instances = odd;
    const auto shown = [](const MaskedWall& one) {
        return mean(render_linear(test_device(), one.shot(14, "light-prepass")));
    };
    const double a = shown(wall), b = shown(other);
    EXPECT_NEAR(shown(both), a + b, 1e-6) << "squares do not meet: each as if it were alone";
    EXPECT_GT(a, 1.3 * b);
}

TEST(MaskCoverage, OfACasterKeepsItsShadow) {
    TestWorld world;
    world.add_material({.name = "floor", .metallic = 0, .roughness = 1});
    world.add(square(2));
    Material leaves{.name = "leaves", .alpha_mode = AlphaMode::mask};
    leaves.double_sided = true;
    leaves.base_colour_texture = {.image = world.add_image(512, 512, white_texels(512, patterns[0].alpha))};
    world.add_material(leaves);
    Primitive caster = square(1.5f);
    for (glm::vec2& uv : caster.texcoords[0])
        uv *= 4; // many texels under one of the map, and many of these
    world.add(caster, glm::translate(glm::dmat4(1), {2.4, 0, 2.4})); // aside: its shadow alone is seen
    world.add_light({.kind = LightKind::directional, .intensity = 2}, {}, {-1, 0, -1});
    Shot shot{.world = &world.world,
              .camera = front_camera(2.1, 1),
              .width = 96,
              .height = 96,
              .settings = {{"shadows", "on"}, {"shadow-budget", "65536"}}};
    shot.settings["texture-filter"] = "auto";
    for (const char* renderer : {"light-prepass", "multipass"}) {
        shot.renderer = renderer;
        const Image picture = render_linear(test_device(), shot);
        const double right = reference_mean(shot);
        EXPECT_NEAR(mean(picture), right, 0.05 * right) << renderer;
    }
    expect_validation_clean(test_device());
}

TEST(MaskCoverage, OfADecalStaysToo) {
    TestWorld world;
    world.add_material({.name = "wall", .base_colour = {0, 0, 0, 1}, .unlit = false});
    world.add(square(3));
    Material mask{
        .name = "holes", .base_colour = {1, 1, 1, 1}, .metallic = 0, .roughness = 1, .alpha_mode = AlphaMode::mask};
    mask.base_colour_texture = {.image = world.add_image(128, 128, white_texels(128, patterns[0].alpha))};
    world.scene.materials.push_back(mask);
    for (int i = 0; i < 9; ++i) {
        PlacedDecal decal{};
        decal.decal.material = 1;
        decal.transform = glm::translate(glm::dmat4(1), {1.3 * (i % 3) - 1.3, 1.27 * (i / 3) - 1.27, 0});
        world.world.decals.push_back(decal);
    }
    world.world.ambient = {0.9f, 0.9f, 0.9f};
    for (const char* renderer : {"light-prepass", "deferred"}) {
        Shot shot{.world = &world.world, .camera = front_camera(6), .width = 96, .height = 96, .renderer = renderer};
        shot.settings["texture-filter"] = "auto"; // 18 pixels each
        const double right = reference_mean(shot);
        EXPECT_NEAR(mean(render_linear(test_device(), shot)), right, 0.16 * right) << renderer; // of 32 x 32 texels
    }
    expect_validation_clean(test_device());
}

TEST(MaskCoverage, OfTheCaseThatOthersReported) {
    const std::filesystem::path folder = std::filesystem::path(PRELIGHT_SHARED_SCENES) / ".." / "cases";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no cases beside the repository";
    for (const char* name : {"mask_far.glb", "mask_near.glb"}) {
        const Scene scene = load_gltf(folder / name);
        const World world = resolve(scene);
        for (const std::string& renderer : device_renderers) {
            const Shot shot{.world = &world,
                            .camera = world.cameras.at(0),
                            .width = 256,
                            .height = 256,
                            .settings = {{"texture-filter", "auto"}},
                            .renderer = renderer};
            const double right = reference_mean(shot); // of a picture with 700 pixels of it
            EXPECT_NEAR(mean(render_linear(test_device(), shot)), right, 0.15 * right) << name << ", " << renderer;
        }
    }
}

} // namespace
} // namespace prelight
