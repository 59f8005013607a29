#include "worlds.hpp"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <prelight/error.hpp>
#include <reference/reference_renderer.hpp>

namespace prelight {
namespace {

using ::testing::HasSubstr;
using Fresnel = ReferenceForm::Fresnel;

std::string usage_error(const RenderOptions& options) {
    try {
        make_reference_renderer(options);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

/// Two lights, so that the forms of the model differ, and a blocker, so that shadows do.
struct TwoLights : TestWorld {
    PlacedCamera camera = look_at(Camera{}, {3, 0, 2}, {0, 0, 0}, {0, 0, 1});
    TwoLights() {
        add_material({.base_colour = {0.8f, 0.4f, 0.2f, 1}, .metallic = 0.3f, .roughness = 0.4f});
        TextureRef& texture = scene.materials.back().base_colour_texture;
        texture.image = add_image(2, 1, {255, 255, 255, 255, 60, 120, 180, 255});
        texture.sampler.mag = Filter::nearest;
        add(square(4));
        add(sphere(16), glm::scale(glm::translate(glm::dmat4(1), {0, 0, 0.5}), glm::dvec3(0.3)));
        add_light({.colour = {1, 0.8f, 0.6f}, .intensity = 10, .range = 5, .shininess = 0.02f}, {0.5, 1, 1.5});
        add_light({.colour = {0.2f, 0.5f, 1}, .intensity = 6, .shininess = 0.01f}, {-1.2, -0.4, 0.8});
        world.ambient = {0.02f, 0.03f, 0.04f};
        world.triangles = 2 + 16 * 16;
    }
    Image linear(std::map<std::string, std::string> settings, Shading shading) const {
        const auto renderer =
            make_reference_renderer({.width = 32, .height = 18, .shading = shading, .settings = settings});
        renderer->set_world(world);
        renderer->render(camera);
        return renderer->read("linear");
    }
};

bool same(const Image& a, const Image& b) { return a.pixels == b.pixels; }

TEST(ReferenceRenderer, EverySettingReachesTheForm) {
    const TwoLights test;
    const auto form = [&](ReferenceForm wanted, bool antialiased = true) {
        wanted.specular_antialiasing = antialiased;
        return render_reference(test.world, test.camera, 32, 18, 0, wanted).linear;
    };
    const Image full = form({.fresnel = Fresnel::full});
    EXPECT_TRUE(same(test.linear({}, Shading::ggx), full)) << "default: full";
    for (const auto& [name, fresnel] :
         {std::pair("weighted", Fresnel::weighted), {"nv", Fresnel::nv}, {"mono", Fresnel::mono}}) {
        const Image image = test.linear({{"model", name}}, Shading::ggx);
        EXPECT_TRUE(same(image, form({.fresnel = fresnel}))) << name;
        EXPECT_FALSE(same(image, full)) << name;
    }
    const Image light = test.linear({{"ambient", "light"}}, Shading::ggx);
    EXPECT_TRUE(same(light, form({.fresnel = Fresnel::full, .ambient_as_light = true})));
    EXPECT_FALSE(same(light, full));
    const Image grey = test.linear({{"reflectance", "grey"}}, Shading::ggx);
    EXPECT_TRUE(same(grey, form({.fresnel = Fresnel::full, .grey_reflectance = true})));
    EXPECT_FALSE(same(grey, full));
    const Image shadows = test.linear({{"shadows", "on"}}, Shading::ggx);
    EXPECT_TRUE(same(shadows, form({.fresnel = Fresnel::full, .shadows = true})));
    EXPECT_FALSE(same(shadows, full));
    const Image plain = test.linear({{"specular-antialiasing", "off"}}, Shading::ggx);
    EXPECT_TRUE(same(plain, form({.fresnel = Fresnel::full}, false)));
    EXPECT_FALSE(same(plain, full));
    const Image nearest = test.linear({{"texture-filter", "sampler"}}, Shading::ggx);
    EXPECT_TRUE(same(nearest, form({.fresnel = Fresnel::full, .bilinear_level0 = false})));
    EXPECT_FALSE(same(nearest, full));

    const Image phong = form({.shading = Shading::phong});
    EXPECT_TRUE(same(test.linear({}, Shading::phong), phong));
    EXPECT_FALSE(same(phong, full));
    const auto expect_phong = [&](const char* key, const char* value, ReferenceForm wanted) {
        wanted.shading = Shading::phong;
        const Image image = test.linear({{key, value}}, Shading::phong);
        EXPECT_TRUE(same(image, form(wanted))) << key;
        EXPECT_FALSE(same(image, phong)) << key;
    };
    expect_phong("specular-gate", "step", {.gate_by_step = true});
    expect_phong("specular-vector", "reflection", {.reflection_vector = true});
    expect_phong("specular-light", "mono", {.mono_specular = true});
}

/// What has an effect with several samples a pixel only.
const std::map<std::string, std::string> several_samples{
    {"msaa-light", "pixel"}, {"msaa-material", "fragment"}, {"msaa-geometry", "fragment"}, {"msaa-shadows", "pixel"}};

TEST(ReferenceRenderer, SeveralSamples) {
    const TwoLights test;
    const auto rendered = [&](const std::map<std::string, std::string>& more) {
        std::map<std::string, std::string> settings{{"shadows", "on"}};
        settings.insert(more.begin(), more.end());
        auto renderer = make_reference_renderer(
            {.width = 32, .height = 18, .msaa = 4, .settings = settings, .views = {"depth", "normal"}});
        renderer->set_world(test.world);
        renderer->render(test.camera);
        return renderer;
    };
    ReferenceForm form{.fresnel = Fresnel::full, .shadows = true, .specular_antialiasing = true};
    const auto expect = [&](Renderer& renderer, const ReferenceSamples& samples) {
        form.samples = samples;
        const ReferencePicture picture = render_reference(test.world, test.camera, 32, 18, 0, form);
        EXPECT_TRUE(same(renderer.read("linear"), picture.linear));
        EXPECT_TRUE(same(renderer.read("final"), picture.display(Tonemap::pbr_neutral)));
        EXPECT_FALSE(same(renderer.read("final"), tonemap(picture.linear, Tonemap::pbr_neutral)));
    };
    using Light = ReferenceSamples::Light;
    using Rate = ReferenceSamples::Rate;
    const auto truth = rendered({});
    expect(*truth, {.count = 4});
    expect(*rendered({{"msaa-light", "pixel"}}), {.count = 4, .light = Light::pixel});
    expect(*rendered({{"msaa-light", "fragment"}}), {.count = 4, .light = Light::fragment});
    expect(*rendered({{"msaa-material", "fragment"}}), {.count = 4, .material = Rate::fragment});
    expect(*rendered({{"msaa-geometry", "fragment"}}), {.count = 4, .geometry = Rate::fragment});
    expect(*rendered({{"msaa-shadows", "pixel"}}), {.count = 4, .shadows_per_pixel = true});
    for (const auto& [key, value] : several_samples)
        EXPECT_FALSE(same(rendered({{key, value}})->read("linear"), truth->read("linear"))) << key;
    // Views show sample 0, whatever is evaluated how often.
    for (const char* view : {"depth", "normal"})
        EXPECT_TRUE(same(rendered({{"msaa-light", "pixel"}})->read(view), truth->read(view))) << view;
}

TEST(ReferenceRenderer, RefusesWhatItDoesNotOffer) {
    EXPECT_THAT(usage_error({.settings = {{"light-culling", "clusters"}}}),
                HasSubstr("unknown setting light-culling (there are: model, "));
    EXPECT_THAT(usage_error({.settings = {{"model", "exact"}}}),
                HasSubstr("model=exact: not one of weighted, nv, mono, full"));
    EXPECT_THAT(usage_error({.views = {"stencil"}}), HasSubstr("unknown view stencil"));
    EXPECT_THAT(usage_error({.preset = "engel"}), HasSubstr("preset engel"));
    for (const uint32_t samples : {0u, 3u, 8u, 16u})
        EXPECT_THAT(usage_error({.msaa = samples}), HasSubstr(fmt::format("--msaa {}: not one of 1, 2, 4", samples)));
    for (const auto& [key, value] : several_samples) {
        EXPECT_THAT(usage_error({.settings = {{key, value}, {"shadows", "on"}}}),
                    HasSubstr("--set " + key + "=" + value + ": needs --msaa 2 or 4, and it is 1"));
        EXPECT_EQ(usage_error({.msaa = 2, .settings = {{key, value}, {"shadows", "on"}}}), "nothing was thrown");
    }
    EXPECT_THAT(usage_error({.msaa = 4, .settings = {{"msaa-shadows", "pixel"}}}), HasSubstr("needs shadows=on"));
    EXPECT_EQ(usage_error({.settings = {{"msaa-light", "samples"}}}), "nothing was thrown");
    EXPECT_THAT(usage_error({.count_pairs = true}), HasSubstr("--count-pairs"));
    EXPECT_THAT([] { make_reference_renderer({.width = 0}); }, testing::ThrowsMessage<Error>(HasSubstr("0x720")));
    EXPECT_EQ(usage_error({}), "nothing was thrown");
}

TEST(ReferenceRenderer, ViewsAreReadableAndAsked) {
    const TwoLights test;
    RenderOptions options{.width = 64, .height = 36, .exposure = 1};
    for (const std::string& view : reference_info().views)
        options.views.push_back(view);
    const auto renderer = make_reference_renderer(options);
    EXPECT_THROW(renderer->read("final"), Error);
    EXPECT_THROW(renderer->render(test.camera), Error);
    renderer->set_world(test.world);
    renderer->render(test.camera);
    for (const std::string& view : options.views) {
        const Image image = renderer->read(view);
        ASSERT_EQ(image.pixels.size(), 64u * 36u) << view;
        float low = 2, high = -1;
        for (const glm::vec3& pixel : image.pixels)
            for (int channel = 0; channel < 3; ++channel) {
                low = std::min(low, pixel[channel]);
                high = std::max(high, pixel[channel]);
            }
        EXPECT_GE(low, 0) << view;
        if (view == "layers")
            continue; // nothing is blended here
        EXPECT_GT(high - low, 0.2f) << view << " is flat";
        if (view != "linear") {
            EXPECT_LE(high, 1) << view;
        }
    }
    EXPECT_TRUE(same(renderer->read("final"), tonemap(renderer->read("linear"), Tonemap::pbr_neutral)));
    EXPECT_THROW(renderer->read("stencil"), UsageError);

    const auto plain = make_reference_renderer({.width = 8, .height = 8});
    plain->set_world(test.world);
    plain->render(test.camera);
    EXPECT_NO_THROW(plain->read("final"));
    EXPECT_THROW(plain->read("depth"), UsageError) << "was not asked for";
}

TEST(ReferenceRenderer, Stats) {
    const TwoLights test;
    const auto renderer = make_reference_renderer({.width = 32, .height = 18, .settings = {{"model", "nv"}}});
    renderer->set_world(test.world);
    renderer->render(test.camera, 3);
    const Stats stats = renderer->stats();
    EXPECT_EQ(stats.lights, 2u);
    EXPECT_EQ(stats.triangles, 258u);
    EXPECT_EQ(stats.draws, 2u);
    EXPECT_EQ(stats.frames, 3u);
    EXPECT_GT(stats.wall_ms.min, 0);
    EXPECT_LE(stats.wall_ms.min, stats.wall_ms.median);
    EXPECT_LE(stats.wall_ms.median, stats.wall_ms.max);
    EXPECT_GT(stats.cpu_ms.max, 0);
    EXPECT_EQ(stats.settings.at("model"), "nv");
    EXPECT_EQ(stats.settings.at("shadows"), "off");
    EXPECT_EQ(stats.settings.size(), reference_info().settings.size());
}

} // namespace
} // namespace prelight
