// What the words of settings make of blended materials.
#include "panes.hpp"
#include <gmock/gmock.h>
#include <prelight/error.hpp>
#include <reference/reference_renderer.hpp>

namespace prelight {
namespace {

using Transparency = ReferenceForm::Transparency;
using Shadows = ReferenceForm::TransparentShadows;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A wall, a lamp and between them a pane with alpha from side to side.
struct Shop : TestWorld {
    Shop() {
        add_material({.metallic = 0});
        add(square(30));
        Material pane{.base_colour = {0.2f, 0.9f, 0.3f, 0.6f}, .alpha_mode = AlphaMode::blend};
        add_material(pane);
        Primitive graded = square(5);
        graded.colours = {{1, 1, 1, 0.2f}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0.2f}};
        add(graded, glm::rotate(at_height(2), 0.3, glm::dvec3(0, 0, 1)));
        add_light({.intensity = 40}, {1, 2, 4});
    }
};

std::unique_ptr<Renderer> shown_by(const Shop& shop, const std::map<std::string, std::string>& settings,
                                   uint32_t samples = 1, const std::vector<std::string>& views = {}) {
    auto renderer = make_reference_renderer(
        {.width = columns, .height = rows, .msaa = samples, .settings = settings, .views = views});
    renderer->set_world(shop.world);
    renderer->render(metre_camera(ProjectionKind::perspective));
    return renderer;
}

ReferencePicture formed(const Shop& shop, const ReferenceForm& form) {
    return in_metres(shop, form, ProjectionKind::perspective);
}

TEST(TransparencySettings, LayersUnlessTheySayOpaque) {
    const Shop shop;
    ReferenceForm form = in_layers;
    form.specular_antialiasing = true;
    const Image layers = formed(shop, form).linear;
    EXPECT_TRUE(shown_by(shop, {})->read("linear").pixels == layers.pixels);
    form.transparency = Transparency::opaque;
    const Image opaque = formed(shop, form).linear;
    EXPECT_TRUE(shown_by(shop, {{"transparency", "opaque"}})->read("linear").pixels == opaque.pixels);
    EXPECT_FALSE(layers.pixels == opaque.pixels);
}

TEST(TransparencySettings, ShadowsOfPanes) {
    const Shop shop;
    ReferenceForm form = in_layers;
    form.specular_antialiasing = true;
    form.shadows = true;
    std::vector<Image> pictures;
    for (const auto& [word, shadows] :
         {std::pair("opaque", Shadows::opaque), {"filtered", Shadows::filtered}, {"none", Shadows::none}}) {
        form.transparent_shadows = shadows;
        pictures.push_back(shown_by(shop, {{"shadows", "on"}, {"transparent-shadows", word}})->read("linear"));
        EXPECT_TRUE(pictures.back().pixels == formed(shop, form).linear.pixels) << word;
    }
    EXPECT_TRUE(shown_by(shop, {{"shadows", "on"}})->read("linear").pixels == pictures[1].pixels);
    EXPECT_FALSE(pictures[1].pixels == pictures[0].pixels);
    EXPECT_FALSE(pictures[1].pixels == pictures[2].pixels);
    EXPECT_THAT(
        [&] {
            shown_by(shop, {{"transparent-shadows", "none"}});
        },
        ThrowsMessage<UsageError>(HasSubstr("needs shadows=on")));
    EXPECT_THAT(
        [&] {
            shown_by(shop, {{"shadows", "on"}, {"transparency", "opaque"}, {"transparent-shadows", "none"}});
        },
        ThrowsMessage<UsageError>(HasSubstr("needs another value than transparency=opaque")));
}

TEST(TransparencySettings, LayersOfSeveralSamples) {
    const Shop shop;
    ReferenceForm form = in_layers;
    form.specular_antialiasing = true;
    form.samples = {.count = 4};
    const Image at_samples = shown_by(shop, {}, 4)->read("linear");
    EXPECT_TRUE(at_samples.pixels == formed(shop, form).linear.pixels);
    form.samples.layers = SampleRate::fragment;
    const Image at_fragments = shown_by(shop, {{"msaa-layers", "fragment"}}, 4)->read("linear");
    EXPECT_TRUE(at_fragments.pixels == formed(shop, form).linear.pixels);
    EXPECT_FALSE(at_fragments.pixels == at_samples.pixels);
    EXPECT_THAT(
        [&] {
            shown_by(shop, {{"msaa-layers", "fragment"}});
        },
        ThrowsMessage<UsageError>(HasSubstr("needs --msaa 2 or 4")));
}

TEST(TransparencySettings, ViewsShowWhatIsOpaqueAndHowManyLayers) {
    const Shop shop;
    Shop bare;
    bare.world.instances.pop_back();
    const std::vector<std::string> views{"depth", "normal", "albedo", "diffuse-light", "light-count", "layers"};
    const auto renderer = shown_by(shop, {}, 1, views), without = shown_by(bare, {}, 1, views);
    for (const std::string& view : views)
        EXPECT_EQ(renderer->read(view).pixels == without->read(view).pixels, view != "layers") << view;
    const Image layers = renderer->read("layers");
    EXPECT_EQ(layers.at(columns / 2, rows / 2), glm::vec3(0, 0, 1)); // one, as of lights
    EXPECT_EQ(layers.at(0, 0), glm::vec3(0));
}

TEST(TransparencySettings, OfAnyRendererNameTheForm) {
    const auto of = [](const std::map<std::string, std::string>& settings, uint32_t samples = 1) {
        return reference_form(Shading::ggx, settings, samples);
    };
    EXPECT_EQ(of({}).transparency, Transparency::opaque);
    EXPECT_EQ(of({{"transparency", "opaque"}}), of({}));
    for (const char* way : {"layers", "lists", "sorted", "peeled", "weighted", "half-samples"})
        EXPECT_EQ(of({{"transparency", way}}).transparency, Transparency::layers) << way;
    EXPECT_EQ(of({{"transparency", "lists"}}).transparent_shadows, Shadows::filtered);
    EXPECT_EQ(of({{"transparency", "lists"}, {"transparent-shadows", "none"}}).transparent_shadows, Shadows::none);
    EXPECT_EQ(of({{"transparent-shadows", "opaque"}}).transparent_shadows, Shadows::opaque);
    EXPECT_EQ(of({{"transparent-shadows", "stochastic"}}).transparent_shadows, Shadows::filtered);
    // Blended surfaces are drawn as forward renderers draw, whatever else does with several samples.
    EXPECT_EQ(of({{"transparency", "lists"}, {"msaa-light", "samples"}}, 4).samples.layers, SampleRate::fragment);
    EXPECT_EQ(of({{"transparency", "lists"}, {"msaa-layers", "sample"}}, 4).samples.layers, SampleRate::sample);
    EXPECT_EQ(of({{"transparency", "opaque"}}, 4).samples.layers, SampleRate::sample);
    EXPECT_EQ(of({{"transparency", "lists"}}, 1).samples, ReferenceSamples{});
    EXPECT_TRUE(of({{"transparency", "half-samples"}}, 4).half_samples);
    EXPECT_FALSE(of({{"transparency", "half-samples"}}, 1).half_samples);
    EXPECT_FALSE(of({{"transparency", "lists"}}, 4).half_samples);
}

} // namespace
} // namespace prelight
