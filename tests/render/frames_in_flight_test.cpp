// Frames in flight: the host prepares one while the device draws another, and nobody sees it.
#include "garden.hpp"
#include "vulkan_calls.hpp"
#include <gpu/context.hpp>
#include <gpu/world_view.hpp>
#include <passes/light_pass.hpp>
#include <prelight/vary.hpp>

namespace prelight {
namespace {

struct Step {
    std::vector<PlacedLight> lights;
    PlacedCamera camera;
};

/// Lights that turn, come and go, under a camera that moves.
std::vector<Step> steps(const Garden& garden) {
    std::vector<Step> all;
    Step step{garden.world.lights, garden.camera};
    for (int i = 0; i < 6; ++i) {
        rotate_lights(step.lights, garden.at(0, 0, 0), 0.4);
        step.camera.position += glm::dvec3(0.2, 0.1, -0.1);
        if (i == 2) // more than there is room for, and wider: lists grow while a frame is in flight
            for (int n = 0; n < 50; ++n)
                step.lights.push_back({garden.point(6, 2), garden.at(0.18 * n - 4.5, 1, 2)});
        if (i == 4)
            step.lights.resize(20);
        all.push_back(step);
    }
    return all;
}

class EachWay : public testing::TestWithParam<Shot> {};

std::vector<Shot> ways_in_flight() {
    std::vector<Shot> shots;
    for (const char* culling : {"volumes", "rectangles", "tiles", "clusters"})
        shots.push_back({.settings = {{"light-culling", culling}}});
    shots.push_back({.renderer = "deferred"});
    shots.push_back({.renderer = "multipass"});
    shots.push_back({.settings = {{"lights", "grid"}}, .renderer = "z-prepass"});
    for (const char* renderer : {"light-prepass", "deferred", "z-prepass", "multipass"})
        shots.push_back({.renderer = renderer, .samples = 4});
    return shots;
}
INSTANTIATE_TEST_SUITE_P(FramesInFlight, EachWay, testing::ValuesIn(ways_in_flight()), [](const auto& way) {
    std::string name = way.param.renderer;
    for (const auto& [key, value] : way.param.settings)
        name += "_" + value;
    if (way.param.samples > 1)
        name += "_samples";
    std::erase(name, '-');
    return name;
});

// Each picture after frames of which none was waited for, against the same frame alone.
TEST_P(EachWay, LeaveTheSamePicturesAsFramesAlone) {
    Garden garden;
    garden.add_lights(20, 3, 4);
    Shot shot = GetParam();
    shot.world = &garden.world;
    shot.width = 160, shot.height = 90;
    const std::vector<Step> all = steps(garden);
    RenderOptions options = options_of(shot);
    options.count_pairs = true;
    for (size_t last = 2; last < all.size(); last += 3) {
        const auto renderer = create_renderer(shot.renderer, &test_device(), options);
        const auto alone = create_renderer(shot.renderer, &test_device(), options);
        renderer->set_world(garden.world);
        for (size_t i = 0; i <= last; ++i) {
            renderer->set_lights(all[i].lights);
            renderer->render(all[i].camera, i % 2 ? 3 : 1);
        }
        World world = garden.world;
        world.lights = all[last].lights;
        alone->set_world(world);
        alone->render(all[last].camera);
        EXPECT_TRUE(renderer->read("linear").pixels == alone->read("linear").pixels) << "after " << last;
        EXPECT_EQ(renderer->stats().pairs_contributing, alone->stats().pairs_contributing) << "after " << last;
        EXPECT_EQ(renderer->stats().frames, last % 2 ? 3u : 1u);
    }
    expect_validation_clean(test_device());
}

TEST(FramesInFlight, TheHostWaitsOnlyForTheFrameBeforeTheLast) {
    Garden garden;
    garden.add_lights(60, 3, 4);
    const Shot shot = garden.shot();
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    renderer->stats();
    const auto waits = [&](auto&& work) {
        const VulkanCalls calls;
        work();
        return calls.waits;
    };
    EXPECT_EQ(waits([&] { renderer->render(garden.camera, 2); }), 0u);
    EXPECT_EQ(waits([&] { renderer->stats(); }), 2u);
    EXPECT_EQ(waits([&] { renderer->read("linear"); }), 1u); // its own copy
    EXPECT_EQ(waits([&] { renderer->render(garden.camera, 7); }), 5u);
    const Stats stats = renderer->stats();
    EXPECT_EQ(stats.frames, 7u);
    // Frames follow each other on the device: the distance between their ends is at least its work.
    EXPECT_GE(stats.wall_ms.median, 0.8 * stats.gpu_ms.min);
    expect_validation_clean(test_device());
}

// What a frame reads was written for it alone: the host has written the next one's before it begins.
TEST(FramesInFlight, WhatAFrameReadsIsLeftAloneUntilItIsDone) {
    Garden garden;
    garden.add_lights(60, 3, 4);
    const std::vector<Step> all = steps(garden);
    auto& context = dynamic_cast<gpu::Context&>(test_device());
    WorldView on_device(context, garden.world, {.raster = {{160, 90}}, .culling = resident::LightCulling::tiles});
    resident::View& view = on_device.view;
    graph::FrameGraph graph(context);
    const gpu::Buffer counters(context, "pair counters", 90 * 2 * sizeof(uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                               gpu::BufferPlace::readback);
    const auto surface = passes::depth_normal_pass(graph, view, {});
    const auto light = passes::make_light_buffer(graph, view, {});
    passes::LightingInputs lighting{
        .surface = surface, .model = {}, .target = light.target, .pair_counters = &counters};
    lighting.lists = passes::screen_light_lists(graph, view, "light", lighting, {.tile_size = 8});
    passes::light_pass(graph, view, "light", lighting);
    graph.keep(light.diffuse);
    graph.compile();
    const auto picture = [&](size_t step, uint32_t slot, bool overtaken) {
        on_device.lights.replace(all[step].lights);
        view.update(all[step].camera, slot);
        context.run("frame", [&](VkCommandBuffer commands) {
            graph.record(commands, {slot, true});
            if (overtaken) { // by the next one, before the device has begun
                on_device.lights.replace(all[step + 1].lights);
                view.update(all[step + 1].camera, 1 - slot);
            }
        });
        return graph.read_back(light.diffuse);
    };
    for (const uint32_t slot : {0u, 1u}) {
        const auto alone = picture(0, slot, false);
        EXPECT_TRUE(picture(0, slot, true) == alone);
        EXPECT_FALSE(picture(1, slot, false) == alone) << "the steps look the same";
    }
    expect_validation_clean(test_device());
}

TEST(FramesInFlight, TheHostPreparesAFrameWhileTheDeviceDrawsTheOneBefore) {
    Garden garden;
    garden.add_lights(60, 3, 4);
    const Shot shot = garden.shot();
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    renderer->stats();
    VulkanCalls calls;
    calls.device = dynamic_cast<gpu::Context&>(test_device()).device();
    std::vector<PlacedLight> lights = garden.world.lights;
    constexpr uint64_t frames = 20;
    for (uint64_t view = 0; view < frames; ++view) {
        rotate_lights(lights, garden.at(0, 0, 0), 0.05);
        renderer->set_lights(lights);
        renderer->render(garden.camera);
    }
    renderer->stats();
    EXPECT_EQ(calls.submits, frames);
    EXPECT_GE(calls.overlapping, frames / 2) << "of " << frames << " submissions";
    RecordProperty("overlapping", static_cast<int>(calls.overlapping));
    expect_validation_clean(test_device());
}

TEST(FramesInFlight, FramesTakeTurnsWithTheBuffers) {
    Garden garden;
    garden.add_lights(10, 3, 4);
    const Shot shot = garden.shot();
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    const auto sets = [&] {
        const VulkanCalls calls;
        renderer->render(garden.camera);
        return calls.frame_sets;
    };
    const auto first = sets(), second = sets(), third = sets();
    EXPECT_EQ(first.size(), 1u);
    EXPECT_EQ(second.size(), 1u);
    EXPECT_NE(first, second);
    EXPECT_EQ(first, third);
}

TEST(FramesInFlight, FiguresAreOfTheLastRenderOnly) {
    Garden garden;
    garden.add_lights(10, 3, 4);
    Shot shot = garden.shot();
    shot.settings["light-culling"] = "volumes";
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    EXPECT_EQ(renderer->stats().frames, 0u);
    renderer->set_world(garden.world);
    renderer->render(garden.camera, 5);
    std::vector<PlacedLight> lights = garden.world.lights;
    lights.push_back({garden.spot(0.6f, 5, 6), garden.at(0, 3, 0), {0, -1, 0}});
    renderer->set_lights(lights); // builds anew: what was measured stays
    EXPECT_EQ(renderer->stats().frames, 5u);
    EXPECT_EQ(renderer->stats().passes.size(), 4u);
    renderer->render(garden.camera, 2);
    EXPECT_EQ(renderer->stats().frames, 2u);
    EXPECT_EQ(renderer->stats().lights, lights.size());
    EXPECT_GT(renderer->stats().wall_ms.min, 0);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
