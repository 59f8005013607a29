// The light pre-pass of a scene without lights: no pass prepares for any, until some come.
#include "garden.hpp"
#include <algorithm>
#include <gmock/gmock.h>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

std::vector<std::string> passes_of(const Renderer& renderer) {
    std::vector<std::string> names;
    for (const PassStats& pass : renderer.stats().passes)
        names.push_back(pass.name);
    return names;
}

struct StudioGarden : Garden {
    StudioGarden() { scene.environment = std::make_shared<Environment>(make_environment("studio")); }
    RenderOptions options(uint32_t samples) const {
        Shot shot = Garden::shot();
        shot.width = 96;
        shot.height = 54;
        RenderOptions options = options_of(shot);
        options.msaa = samples;
        options.views = {"final"};
        return options;
    }
};

TEST(Unlit, NoPassIsForLight) {
    const StudioGarden garden;
    for (const uint32_t samples : {1u, 4u}) {
        const auto renderer = create_renderer("light-prepass", &test_device(), garden.options(samples));
        renderer->set_world(garden.world);
        renderer->render(garden.shot().camera);
        const std::vector<std::string> passes = passes_of(*renderer);
        EXPECT_EQ(passes[0], "depth");
        EXPECT_EQ(passes[1], "material");
        EXPECT_LE(passes.size(), 4u) << "background and resolve may follow";
    }
    expect_validation_clean(test_device());
}

/// A view of what the passes would have found brings them back, and changes no picture.
TEST(Unlit, IsThePictureThatAllPassesGive) {
    const StudioGarden garden;
    for (const uint32_t samples : {1u, 4u}) {
        std::vector<Image> pictures;
        for (const bool all : {false, true}) {
            RenderOptions options = garden.options(samples);
            if (all)
                options.views.emplace_back("normal");
            const auto renderer = create_renderer("light-prepass", &test_device(), options);
            renderer->set_world(garden.world);
            renderer->render(garden.shot().camera);
            pictures.push_back(renderer->read("final"));
            const std::vector<std::string> passes = passes_of(*renderer);
            EXPECT_EQ(std::ranges::find(passes, "light") != passes.end(), all);
        }
        EXPECT_TRUE(pictures[0].pixels == pictures[1].pixels) << samples;
    }
    expect_validation_clean(test_device());
}

TEST(Unlit, LightsThatComeAndGoAreSeen) {
    const StudioGarden garden;
    StudioGarden lit;
    lit.add_lights(1, 5, 4);
    const auto fresh = create_renderer("light-prepass", &test_device(), garden.options(1)),
               changed = create_renderer("light-prepass", &test_device(), garden.options(1));
    const PlacedCamera camera = garden.shot().camera;
    const auto picture = [&](Renderer& renderer) {
        renderer.render(camera);
        return renderer.read("final").pixels;
    };
    changed->set_world(garden.world);
    const auto dark = picture(*changed);
    fresh->set_world(lit.world);
    const auto bright = picture(*fresh);
    EXPECT_FALSE(dark == bright);
    changed->set_lights(lit.world.lights);
    EXPECT_TRUE(picture(*changed) == bright);
    changed->set_lights({});
    EXPECT_TRUE(picture(*changed) == dark);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
