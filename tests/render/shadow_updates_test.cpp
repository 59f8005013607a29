// shadow-updates=N: maps are drawn over several frames, and the picture is the one of all of them once they are there.
#include "garden.hpp"

namespace prelight {
namespace {

/// Nine spots with a tile each over spheres, and a sun.
struct SpotGarden : Garden {
    SpotGarden() {
        for (int i = 0; i < 9; ++i)
            add_light(spot(0.5f, 9, 25), {i % 3 * 3.0 - 3, 5, i / 3 * 3.0 - 3}, {0.05 * i - 0.2, -1, -0.1});
        add_light({.kind = LightKind::directional, .intensity = 0.3f}, {0, 0, 0}, {-0.3, -1, -0.5});
    }
    Shot shot(const char* updates) const {
        Shot shot = Garden::shot();
        shot.width = 160;
        shot.height = 90;
        shot.settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}, {"shadow-updates", updates}};
        return shot;
    }
};

std::unique_ptr<Renderer> renderer_of(const Shot& shot) {
    auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(*shot.world);
    return renderer;
}

/// Tiles that the next frame draws.
uint64_t drawn(Renderer& renderer, const Shot& shot) {
    renderer.render(shot.camera);
    return renderer.stats().shadows->tiles_drawn;
}

TEST(ShadowUpdates, SoManyTilesAFrameUntilAllAreThere) {
    const SpotGarden garden;
    const Shot shot = garden.shot("4");
    const std::vector<glm::vec3> all = render_linear(test_device(), garden.shot("all")).pixels;
    const auto renderer = renderer_of(shot);
    EXPECT_EQ(drawn(*renderer, shot), 8u) << "and four cascades";
    Shot unshadowed = shot;
    unshadowed.settings.clear();
    const Image first = renderer->read("linear"), bright = render_linear(test_device(), unshadowed);
    EXPECT_FALSE(first.pixels == all);
    for (size_t i = 0; i < all.size(); ++i) { // who waits is not in shadow
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(first.pixels[i], 0.98f * all[i] - 1e-3f)));
        ASSERT_TRUE(glm::all(glm::lessThanEqual(first.pixels[i], 1.02f * bright.pixels[i] + 1e-3f)));
    }
    EXPECT_EQ(drawn(*renderer, shot), 4u);
    EXPECT_FALSE(renderer->read("linear").pixels == all);
    EXPECT_EQ(drawn(*renderer, shot), 1u);
    EXPECT_TRUE(renderer->read("linear").pixels == all);
    EXPECT_EQ(drawn(*renderer, shot), 0u);
    EXPECT_TRUE(renderer->read("linear").pixels == all);
    expect_validation_clean(test_device());
}

// Two tiles a frame, and two lights that move in each: those that stand get their turn too.
TEST(ShadowUpdates, TheOldestMapComesFirst) {
    SpotGarden garden;
    World world = garden.world;
    Shot shot = garden.shot("2");
    shot.world = &world;
    const auto renderer = renderer_of(shot);
    for (int frame = 0; frame < 5; ++frame)
        drawn(*renderer, shot);
    for (PlacedLight& light : world.lights) // all maps are old now
        light.position.y += 0.2;
    for (int frame = 0; frame < 5; ++frame) {
        for (const size_t i : {0, 1})
            world.lights[i].position.x += 0.1;
        renderer->set_lights(world.lights);
        EXPECT_EQ(drawn(*renderer, shot), 2u);
    }
    EXPECT_EQ(drawn(*renderer, shot), 1u) << "of the two that moved, one had its second turn in the fifth frame";
    EXPECT_EQ(drawn(*renderer, shot), 0u);
    Shot all = shot;
    all.settings["shadow-updates"] = "all";
    EXPECT_TRUE(renderer->read("linear").pixels == render_linear(test_device(), all).pixels);
    expect_validation_clean(test_device());
}

// Extremes and transmittance follow what was drawn.
TEST(ShadowUpdates, EndWithTheSamePictureEverywhere) {
    SpotGarden garden;
    for (const char* renderer : {"deferred", "z-prepass"}) {
        SCOPED_TRACE(renderer);
        Shot shot = garden.shot("3");
        shot.renderer = renderer;
        const auto kept = renderer_of(shot);
        for (int frame = 0; frame < 3; ++frame)
            kept->render(shot.camera);
        Shot all = shot;
        all.settings["shadow-updates"] = "all";
        EXPECT_TRUE(kept->read("linear").pixels == render_linear(test_device(), all).pixels);
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
