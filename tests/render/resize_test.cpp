// Pictures of another size from a renderer that is kept: the same as a new renderer's, with what it has on the device.
#include "every_way.hpp"
#include "garden.hpp"
#include "vulkan_calls.hpp"
#include <prelight/error.hpp>

namespace prelight {
namespace {

class Resized : public testing::TestWithParam<Shot> {};

INSTANTIATE_TEST_SUITE_P(All, Resized, testing::ValuesIn(every_way({.width = 96, .height = 54})), way_name);

std::vector<Shot> sampled_ways() {
    std::vector<Shot> shots;
    for (const std::string& renderer : device_renderers)
        shots.push_back({.width = 96, .height = 54, .renderer = renderer, .samples = 4});
    return shots;
}
INSTANTIATE_TEST_SUITE_P(Samples, Resized, testing::ValuesIn(sampled_ways()), way_name);

Image fresh_picture(const Shot& shot) {
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    return renderer->read("linear");
}

TEST_P(Resized, DrawsWhatANewOneDraws) {
    Garden garden;
    garden.add_lights(20, 3, 4);
    Shot shot = GetParam();
    shot.world = &garden.world;
    shot.camera = garden.camera;
    shot.settings.insert({{"shadows", "on"}, {"shadow-budget", "262144"}});
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->resize(40, 30); // before there is a world
    renderer->set_world(garden.world);
    for (const auto& [width, height] : {std::pair{40u, 30u}, {96u, 54u}, {1u, 1u}}) {
        SCOPED_TRACE(width);
        renderer->resize(width, height);
        renderer->render(garden.camera);
        shot.width = width;
        shot.height = height;
        const Image picture = renderer->read("linear"), expected = fresh_picture(shot);
        ASSERT_EQ(picture.width, width);
        ASSERT_EQ(picture.height, height);
        EXPECT_EQ(picture.pixels, expected.pixels);
        garden.world.lights.resize(garden.world.lights.size() - 3); // the lights that are there stay
        renderer->set_lights(garden.world.lights);
    }
    expect_validation_clean(test_device());
}

TEST(Resize, UploadsNothingOfTheWorldAgain) {
    TestWorld test;
    test.add(square(2));
    for (int i = 0; i < 20; ++i) {
        Material material{.name = "textured"};
        material.base_colour_texture = {.image = test.add_image(2, 2, std::vector<uint8_t>(16, 200))};
        test.add_material(material);
        test.add(square(1));
    }
    const auto renderer = create_renderer("light-prepass", &test_device(), {.width = 64, .height = 36});
    VulkanCalls calls;
    renderer->set_world(test.world);
    const uint64_t images = calls.images, buffers = calls.buffers;
    renderer->resize(80, 45);
    EXPECT_LE(calls.images - images, images - 20) << "textures";
    EXPECT_LE(calls.buffers - buffers, buffers - 4) << "positions, attributes, indices, constants of materials";
}

TEST(Resize, RefusesWhatNoPictureHasAndStaysAsItWas) {
    Garden garden;
    garden.add_lights(5, 3, 4);
    for (const char* name : {"light-prepass", "reference"}) {
        const auto renderer = create_renderer(name, &test_device(), {.width = 32, .height = 18});
        renderer->set_world(garden.world);
        EXPECT_THROW(renderer->resize(0, 18), Error);
        EXPECT_THROW(renderer->resize(32, 0), Error);
        renderer->render(garden.camera);
        EXPECT_EQ(renderer->read("final").width, 32u);
        renderer->resize(16, 9);
        EXPECT_THROW(renderer->read("final"), Error) << "of which frame?";
        renderer->render(garden.camera);
        EXPECT_EQ(renderer->read("final").width, 16u);
    }
    const auto renderer = create_renderer("light-prepass", &test_device(), {.width = 32, .height = 18});
    EXPECT_THROW(renderer->resize(1u << 20, 18), Error);
}

} // namespace
} // namespace prelight
