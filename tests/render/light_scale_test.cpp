// The scale of light buffers in fixed point, Engel's "scale value": found for each frame, and what it does not hold
// told.
#include "garden.hpp"
#include <cmath>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using testing::HasSubstr;
using Words = std::map<std::string, std::string>;

double sum_as_shown(const Image& image) {
    double sum = 0;
    for (const glm::vec3& p : image.pixels)
        for (int c = 0; c < 3; ++c)
            sum += double(std::min(p[c], 1.0f)); // as a picture shows it
    return sum;
}

std::string notes_of(const Stats& stats) {
    std::string all;
    for (const std::string& note : stats.notes)
        all += note + "\n";
    return all;
}

constexpr const char* clipped_line = "hold the largest light";

/// A street at night: neon close to walls, wet ground, some 16 lights on a pixel.
struct City {
    Scene scene = make_scene("city", 1024, 1);
    World world = resolve(scene);
    RenderOptions options(const char* preset) const {
        return {.width = 320, .height = 180, .preset = preset, .settings = {{"texture-filter", "bilinear"}}};
    }
};
const City& city() {
    static const City one;
    return one;
}

struct OnTheCity {
    const char* preset;
    const char* half; ///< its light buffer in half floats
    double psnr;      ///< what eight bits reach, blended light by light
};
void PrintTo(const OnTheCity& preset, std::ostream* out) { *out << preset.preset; }

class PresetOnTheCity : public testing::TestWithParam<OnTheCity> {};

TEST_P(PresetOnTheCity, LosesNoLight) {
    RenderOptions options = city().options(GetParam().preset);
    const Rendered eight = render_with(city().world, city().world.cameras[0], options);
    options.settings["light-buffer"] = GetParam().half;
    const Rendered half = render_with(city().world, city().world.cameras[0], options);
    const double ratio = sum_as_shown(eight.linear) / sum_as_shown(half.linear);
    const double psnr = compare_pixels(eight.linear, half.linear).psnr;
    std::printf("    %.1f dB, %.3f of the light, scales %.2f and %.2f, %llu clipped\n", psnr, ratio,
                eight.stats.light_buffer->diffuse_scale, eight.stats.light_buffer->specular_scale,
                static_cast<unsigned long long>(eight.stats.light_buffer->clipped_pixels));
    EXPECT_NEAR(ratio, 1, 0.025);
    EXPECT_GE(psnr, GetParam().psnr);
    EXPECT_THAT(notes_of(eight.stats), testing::Not(HasSubstr(clipped_line)));
    EXPECT_FALSE(half.stats.light_buffer.has_value());

    options.settings.erase("light-buffer");
    options.settings["light-scale"] = "0.1";
    const Rendered fixed = render_with(city().world, city().world.cameras[0], options);
    EXPECT_THAT(notes_of(fixed.stats), HasSubstr(clipped_line));
    EXPECT_GT(fixed.stats.light_buffer->clipped_pixels, 1000u);
    EXPECT_EQ(fixed.stats.light_buffer->diffuse_scale, 0.1);
    EXPECT_LT(compare_pixels(fixed.linear, half.linear).psnr, psnr - 5);
    expect_validation_clean(test_device());
}

INSTANTIATE_TEST_SUITE_P(LightScale, PresetOnTheCity,
                         testing::Values(OnTheCity{"prelighting", "rgba16f", 40},
                                         OnTheCity{"engel", "packed-rgba16f", 39},
                                         OnTheCity{"round2", "packed-rgba16f", 39}),
                         [](const auto& preset) { return std::string(preset.param.preset); });

struct Lit : Garden {
    explicit Lit(float factor = 1) {
        for (int i = 0; i < 4; ++i)
            add_light(point(9, 6 * factor, {1 - 0.2f * static_cast<float>(i), 0.7f, 0.3f}),
                      {2.6 * i - 3.9, 4.5, 1.0 + 0.3 * i});
        world.ambient *= factor;
        for (Material& material : scene.materials)
            material.emissive *= factor;
    }
    RenderOptions options(const Words& settings, Shading shading = Shading::phong) const {
        RenderOptions options{.width = 160, .height = 90, .shading = shading, .settings = settings};
        options.settings["texture-filter"] = "bilinear";
        return options;
    }
};

/// Targets in fixed point, light by light and written once.
std::vector<std::pair<const char*, Words>> fixed_point_targets() {
    return {{"light-prepass", {{"light-buffer", "rgba8"}, {"light-writes", "blended"}}},
            {"light-prepass", {{"light-buffer", "rgba8"}, {"light-writes", "once"}, {"light-culling", "fullscreen"}}},
            {"light-prepass", {{"light-buffer", "packed-rgba8"}}}, // written once, by tiles
            {"light-prepass", {{"light-buffer", "rgb10a2"}, {"light-writes", "blended"}}},
            {"deferred", {{"accumulation", "rgba8"}, {"light-culling", "volumes"}}},
            {"deferred", {{"accumulation", "rgba8"}, {"g-buffer", "killzone2"}}}};
}

std::string target_name(const std::pair<const char*, Words>& target) {
    std::string name = target.first;
    for (const auto& [key, value] : target.second)
        name += " " + key + "=" + value;
    return name;
}

TEST(LightScale, FitsTheLightOfAnyScene) {
    for (const auto& target : fixed_point_targets()) {
        SCOPED_TRACE(target_name(target));
        // The same scene under a thousandth and a thousand times the light, exposed alike: the scale follows.
        std::vector<Image> pictures;
        for (const double ev : {-10.0, 0.0, 10.0}) {
            const Lit garden(static_cast<float>(std::exp2(-ev)));
            RenderOptions options = garden.options(target.second);
            options.exposure = ev;
            const Rendered picture = render_with(garden.world, garden.camera, options, target.first);
            EXPECT_THAT(notes_of(picture.stats), testing::Not(HasSubstr(clipped_line)));
            pictures.push_back(picture.linear);
        }
        EXPECT_GE(compare_pixels(pictures[0], pictures[1]).psnr, 50);
        EXPECT_GE(compare_pixels(pictures[2], pictures[1]).psnr, 50);
        // And of a picture that is brighter by three stops.
        const Lit garden;
        RenderOptions options = garden.options(target.second);
        options.exposure = 3;
        const Image eight = render_with(garden.world, garden.camera, options, target.first).linear;
        for (const char* key : {"light-buffer", "accumulation"})
            if (options.settings.contains(key))
                options.settings[key] = options.settings[key].starts_with("packed") ? "packed-rgba16f" : "rgba16f";
        const Image half = render_with(garden.world, garden.camera, options, target.first).linear;
        const double psnr = compare_pixels(eight, half).psnr, ratio = sum_as_shown(eight) / sum_as_shown(half);
        std::printf("    %s: %.1f dB, %.3f of the light\n", target_name(target).c_str(), psnr, ratio);
        EXPECT_GE(psnr, 36);
        EXPECT_NEAR(ratio, 1, 0.02);
    }
    expect_validation_clean(test_device());
}

TEST(LightScale, TheFirstFrameIsAsAnyLaterOne) {
    for (const auto& target : fixed_point_targets()) {
        SCOPED_TRACE(target_name(target));
        const Lit garden, bright(40);
        const RenderOptions options = garden.options(target.second);
        const auto renderer = create_renderer(target.first, &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        const Image first = renderer->read("final");
        renderer->render(garden.camera, 3);
        EXPECT_TRUE(renderer->read("final").pixels == first.pixels) << "a still scene";
        renderer->set_lights(bright.world.lights);
        renderer->render(garden.camera, 2);
        const double scale = renderer->stats().light_buffer->diffuse_scale;
        renderer->set_lights(garden.world.lights);
        renderer->render(garden.camera);
        EXPECT_TRUE(renderer->read("final").pixels == first.pixels) << "whatever was there before";
        EXPECT_GT(scale, renderer->stats().light_buffer->diffuse_scale);
        const auto again = create_renderer(target.first, &test_device(), options);
        again->set_world(garden.world);
        again->render(garden.camera);
        EXPECT_TRUE(again->read("final").pixels == first.pixels) << "two runs";
    }
    expect_validation_clean(test_device());
}

/// The sums that materials read are codes times the scale: a channel is full where its sum is the scale.
TEST(LightScale, CountsEachPixelWithAFullChannel) {
    const Lit garden(3);
    for (const char* writes : {"blended", "once"}) {
        RenderOptions options =
            garden.options({{"light-buffer", "rgba8"}, {"light-writes", writes}, {"light-scale", "0.25"}});
        options.views = {"diffuse-sum", "specular-sum"};
        const auto renderer = create_renderer("light-prepass", &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        const Image diffuse = renderer->read("diffuse-sum"), specular = renderer->read("specular-sum");
        uint64_t full = 0;
        for (size_t i = 0; i < diffuse.pixels.size(); ++i) {
            const glm::vec3 most = glm::max(diffuse.pixels[i], specular.pixels[i]);
            full += std::max(most.r, std::max(most.g, most.b)) >= 0.25f;
        }
        EXPECT_GT(full, 1000u);
        EXPECT_LT(full, diffuse.pixels.size());
        EXPECT_EQ(renderer->stats().light_buffer->clipped_pixels, full) << writes;
    }
    expect_validation_clean(test_device());
}

TEST(LightScale, IsToldOfDeferredLightInBytesToo) {
    const Lit garden(20);
    RenderOptions options = garden.options({{"accumulation", "rgba8"}, {"light-scale", "0.1"}});
    EXPECT_THAT(notes_of(render_with(garden.world, garden.camera, options, "deferred").stats), HasSubstr(clipped_line));
    options.settings["light-scale"] = "auto";
    EXPECT_THAT(notes_of(render_with(garden.world, garden.camera, options, "deferred").stats),
                testing::Not(HasSubstr(clipped_line)));
    options.settings = {};
    EXPECT_FALSE(render_with(garden.world, garden.camera, options, "deferred").stats.light_buffer.has_value());
    expect_validation_clean(test_device());
}

TEST(LightScale, SeesShadowsAndDarkness) {
    // Without light there is nothing to choose from, and nothing is divided by it.
    const Garden dark;
    const Lit any;
    const Rendered none = render_with(dark.world, dark.camera, any.options({{"light-buffer", "rgba8"}}));
    for (const glm::vec3& pixel : none.linear.pixels)
        ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z));
    // A light that shines through a wall would set the scale, if it were not for the wall's shadow.
    for (const char* memory : {"atlas", "reuse"}) {
        const RenderOptions options = any.options(
            {{"light-buffer", "rgba8"}, {"shadows", "on"}, {"shadow-budget", "1048576"}, {"shadow-memory", memory}});
        const Rendered shadowed = render_with(any.world, any.camera, options);
        EXPECT_GT(shadowed.stats.light_buffer->diffuse_scale, 0);
        EXPECT_LE(shadowed.stats.light_buffer->clipped_pixels, 14u);
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
