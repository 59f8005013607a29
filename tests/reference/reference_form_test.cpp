// The form that belongs to settings in force, held against the reference renderer's own reading of
// the same words.
#include "worlds.hpp"
#include <gtest/gtest.h>
#include <prelight/reference.hpp>
#include <reference/reference_renderer.hpp>

namespace prelight {
namespace {

struct Words {
    const char* name;
    std::map<std::string, std::string> settings;
};

void PrintTo(const Words& words, std::ostream* stream) { *stream << words.name; }

/// Light of three lights, an ambient one among them, on two materials: every form differs.
struct ThreeLights : TestWorld {
    PlacedCamera camera = look_at(Camera{}, {3, 0, 2}, {0, 0, 0}, {0, 0, 1});
    ThreeLights() {
        add_material({.base_colour = {0.8f, 0.4f, 0.2f, 1}, .metallic = 0.3f, .roughness = 0.4f});
        add(square(4));
        add(sphere(16), glm::scale(glm::translate(glm::dmat4(1), {0, 0, 0.5}), glm::dvec3(0.3)));
        add_light({.colour = {1, 0.8f, 0.6f}, .intensity = 10, .range = 5, .shininess = 0.02f}, {0.5, 1, 1.5});
        add_light({.colour = {0.2f, 0.5f, 1}, .intensity = 6, .shininess = 0.01f}, {-1.2, -0.4, 0.8});
        world.ambient = {0.02f, 0.03f, 0.04f};
    }
};

class ReferenceFormOf : public testing::TestWithParam<Words> {};

TEST_P(ReferenceFormOf, SettingsIsWhatTheReferenceTakesThemFor) {
    const ThreeLights test;
    for (const Shading shading : {Shading::ggx, Shading::phong}) {
        std::map<std::string, std::string> settings = GetParam().settings;
        const Image ours =
            render_reference(test.world, test.camera, 24, 16, 0, reference_form(shading, settings)).linear;
        if (settings["model"] == "mono") // the reference has a word of its own for it in [phong]
            settings["specular-light"] = "mono";
        if (settings.erase("g-buffer"))
            settings["reflectance"] = "grey";
        if (settings["model"].empty())
            settings.erase("model");
        settings.emplace("specular-antialiasing", "off"); // what a renderer without the setting has
        // The form heeds nothing that the renderer refuses for want of an effect.
        for (const char* of_phong : {"specular", "specular-gate", "specular-vector", "specular-light"})
            if (shading == Shading::ggx)
                settings.erase(of_phong);
        if (shading == Shading::phong)
            settings.erase("model");
        const auto renderer =
            make_reference_renderer({.width = 24, .height = 16, .shading = shading, .settings = settings});
        renderer->set_world(test.world);
        renderer->render(test.camera);
        EXPECT_TRUE(renderer->read("linear").pixels == ours.pixels);
    }
}
INSTANTIATE_TEST_SUITE_P(Each, ReferenceFormOf,
                         testing::Values(Words{"none", {}}, Words{"weighted", {{"model", "weighted"}}},
                                         Words{"antialiased", {{"specular-antialiasing", "on"}}},
                                         Words{"nv", {{"model", "nv"}}}, Words{"mono", {{"model", "mono"}}},
                                         Words{"full", {{"model", "full"}}}, Words{"step", {{"specular-gate", "step"}}},
                                         Words{"reflection", {{"specular-vector", "reflection"}}},
                                         Words{"luv", {{"specular", "luv"}}},
                                         Words{"luminance", {{"specular", "luminance"}, {"ambient", "light"}}},
                                         Words{"fifth", {{"specular", "fifth-channel"}, {"ambient", "light"}}},
                                         Words{"bent", {{"specular", "bent"}}},
                                         Words{"killzone2", {{"g-buffer", "killzone2"}}},
                                         Words{"ambient", {{"ambient", "light"}}}));

TEST(ReferenceFormDefaults, UnknownKeysAndValuesMeanNothing) {
    const ReferenceForm form =
        reference_form(Shading::ggx, {{"light-culling", "tiles"}, {"ambient", "per-object"}, {"model", "auto"}});
    EXPECT_EQ(form.fresnel, ReferenceForm::Fresnel::full);
    EXPECT_FALSE(form.ambient_as_light);
}

TEST(ReferenceFormSamples, AreWhatARenderersSettingsSay) {
    using Light = ReferenceSamples::Light;
    using Rate = ReferenceSamples::Rate;
    const auto of = [](const std::map<std::string, std::string>& settings, uint32_t samples = 4) {
        return reference_form(Shading::ggx, settings, samples).samples;
    };
    const ReferenceSamples truth{.count = 4};
    const ReferenceSamples on_a_device{.count = 4, .geometry = Rate::fragment}; // stores a normal once a fragment
    EXPECT_EQ(of({{"msaa-light", "samples"}}), on_a_device);
    EXPECT_EQ(of({{"msaa-light", "samples"}, {"msaa-geometry", "sample"}}), truth);
    EXPECT_EQ(of({{"msaa-light", "edges"}, {"msaa-material", "sample"}}),
              (ReferenceSamples{.count = 4, .light = Light::edges, .geometry = Rate::fragment}));
    ReferenceSamples edges{.count = 4, .light = Light::edges, .material = Rate::fragment, .geometry = Rate::fragment};
    EXPECT_EQ(of({{"msaa-light", "edges"}, {"msaa-material", "fragment"}}), edges);
    edges.colours_apart = true;
    EXPECT_EQ(of({{"msaa-light", "edges"}, {"g-buffer", "wide"}}), edges);
    EXPECT_EQ(of({{"msaa-light", "samples"}, {"g-buffer", "wide"}}),
              (ReferenceSamples{.count = 4, .material = Rate::fragment, .geometry = Rate::fragment}));
    EXPECT_EQ(
        of({{"msaa-light", "pixel"}, {"msaa-geometry", "fragment"}, {"msaa-shadows", "pixel"}}, 2),
        (ReferenceSamples{.count = 2, .light = Light::pixel, .geometry = Rate::fragment, .shadows_per_pixel = true}));
    // A forward renderer has no light by itself.
    const ReferenceSamples forward{
        .count = 4, .light = Light::fragment, .material = Rate::fragment, .geometry = Rate::fragment};
    EXPECT_EQ(of({}), forward);
    EXPECT_EQ(of({{"msaa-material", "fragment"}}), forward);
    EXPECT_EQ(of({{"msaa-material", "sample"}}), truth);
    for (const char* light : {"pixel", "edges"})
        EXPECT_EQ(of({{"msaa-light", light}, {"msaa-shadows", "pixel"}}, 1), ReferenceSamples{});
    EXPECT_EQ(reference_form(Shading::ggx, {}), ReferenceForm(reference_form(Shading::ggx, {}, 1)));
}

} // namespace
} // namespace prelight
