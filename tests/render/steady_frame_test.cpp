// A frame that draws what was drawn before makes nothing: no memory, no pipeline, no buffer.
#include "every_way.hpp"
#include "garden.hpp"
#include "vulkan_calls.hpp"
#include <fstream>
#include <prelight/scene_io.hpp>
#include <prelight/vary.hpp>
#include <unistd.h>

namespace prelight {
namespace {

/// Each renderer on a device once for each value of the settings that say how lights meet pixels, and
/// with what may leave out geometry.
std::vector<Shot> every_steady_way(const Shot& shot) {
    std::vector<Shot> shots;
    for (const RendererInfo& info : renderer_infos())
        for (const SettingInfo& setting : info.settings)
            if (info.needs_device &&
                (setting.key == "light-culling" || setting.key == "lights" || setting.key == "order"))
                for (const std::string& value : setting.values) {
                    shots.push_back(shot);
                    shots.back().renderer = info.name;
                    shots.back().settings = {{setting.key, value}};
                }
    for (const char* renderer : {"light-prepass", "z-prepass"}) {
        shots.push_back(shot);
        shots.back().renderer = renderer;
        shots.back().settings = {
            {"index-trimming", "device"}, {"material-trimming", "depth"}, {"occlusion", "queries"}};
    }
    for (const char* renderer : {"light-prepass", "multipass"})
        for (const char* filter : {"edge-blur", "smaa"}) {
            shots.push_back(shot);
            shots.back().renderer = renderer;
            shots.back().settings = {{"antialiasing", filter}};
        }
    return shots;
}

TEST(SteadyFrame, MakesNothingWhileLightsAndCameraMove) {
    Garden garden;
    garden.add_lights(40, 3, 4);
    for (int i = 0; i < 5; ++i)
        garden.add_light(garden.spot(0.6f, 5, 6), garden.at(i - 2, 3, 0), {0, -1, 0.1});
    std::vector<Shot> shots = every_steady_way(garden.shot());
    for (const char* memory : {"atlas", "reuse"}) {
        Shot& shadowed = shots.emplace_back(garden.shot());
        shadowed.settings = {{"shadows", "on"}, {"shadow-memory", memory}, {"shadow-budget", "1048576"}};
    }
    for (const Way& way : std::initializer_list<Way>{{"light-prepass", {{"light-culling", "tiles"}}},
                                                     {"light-prepass", {{"light-culling", "volumes"}}},
                                                     {"deferred", {{"light-culling", "tiles"}}},
                                                     {"z-prepass", {{"lights", "grid"}}},
                                                     {"multipass", {{"order", "objects"}}}})
        shots.push_back({.world = &garden.world,
                         .camera = garden.camera,
                         .settings = way.settings,
                         .renderer = way.renderer,
                         .samples = 4});
    for (Shot shot : shots) {
        SCOPED_TRACE(shot.renderer + " " + shot.settings.begin()->second + ", " + std::to_string(shot.samples));
        shot.width = 160, shot.height = 90;
        const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
        renderer->set_world(garden.world);
        std::vector<PlacedLight> lights = garden.world.lights;
        PlacedCamera camera = garden.camera;
        for (int frame = 0; frame < 8; ++frame) {
            const VulkanCalls calls;
            rotate_lights(lights, garden.at(0, 0, 0), 0.05);
            camera.position += glm::dvec3(0.05, 0.02, -0.05);
            renderer->set_lights(lights);
            renderer->render(camera);
            const Stats stats = renderer->stats();
            EXPECT_GE(stats.device_bytes_peak, stats.device_bytes);
            if (frame > 0) { // the first one's camera and lights may have built what is missing
                EXPECT_EQ(calls.pipelines, 0u) << "frame " << frame;
            }
            if (frame < 3)
                continue; // lists find out how much room they need
            EXPECT_EQ(calls.allocations, 0u) << "frame " << frame;
            EXPECT_EQ(calls.buffers + calls.images + calls.descriptor_pools, 0u) << "frame " << frame;
            EXPECT_EQ(stats.created, CreatedObjects{}) << "frame " << frame;
        }
    }
    expect_validation_clean(test_device());
}

uint64_t resident_bytes() {
    uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages; // the second number
    return pages * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

// lavapipe makes some shaders again at every bind and keeps the old ones (docs/notes/software-devices.md): not ours.
TEST(SteadyFrame, LeavesNoMemoryInTheDriver) {
    const Scene scene = make_scene("materials", 9, 1);
    const World world = resolve(scene);
    for (const char* name : {"light-prepass", "deferred", "z-prepass"}) {
        Shot shot{.world = &world, .camera = find_camera(world, "0"), .width = 64, .height = 36};
        shot.renderer = name;
        const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
        renderer->set_world(world);
        const auto draw = [&](int frames) {
            for (int frame = 0; frame < frames; ++frame)
                renderer->render(shot.camera);
            return resident_bytes();
        };
        const uint64_t before = draw(10);
        EXPECT_LT(draw(40), before + (12u << 20)) << name; // with one such shader 30 MiB and more
    }
}

// The count would be 0 as well if nobody counted: a frame whose lights need more room makes it.
TEST(SteadyFrame, CountsTheRoomThatListsTake) {
    Garden garden;
    garden.add_lights(300, 0.1f, 1);
    std::vector<PlacedLight> wide = garden.world.lights;
    for (PlacedLight& light : wide)
        light.light.range = 30;
    Shot shot = garden.shot();
    shot.settings["light-culling"] = "tiles";
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    renderer->set_lights(wide);
    const VulkanCalls calls;
    CreatedObjects created;
    for (int frame = 0; frame < 3; ++frame) {
        renderer->render(garden.camera);
        created.buffers += renderer->stats().created.buffers;
        created.allocations += renderer->stats().created.allocations;
    }
    EXPECT_GE(created.buffers, 1u);
    EXPECT_EQ(created.buffers, calls.buffers);
    EXPECT_EQ(created.allocations, calls.allocations);
    expect_validation_clean(test_device());
}

// A frame after the first of its graph is one frame's work: the warm-up is not drawn again.
TEST(SteadyFrame, WarmsPipelinesOnlyAfterSomethingWasBuilt) {
    Garden garden;
    garden.add_lights(20, 3, 4);
    const Shot shot = garden.shot();
    const auto renderer = create_renderer(shot.renderer, &test_device(), options_of(shot));
    renderer->set_world(garden.world);
    const auto drawn_frames = [&] {
        const VulkanCalls calls;
        renderer->render(garden.camera, 3);
        renderer->stats();
        return calls.submits;
    };
    EXPECT_EQ(drawn_frames(), 4u);
    EXPECT_EQ(drawn_frames(), 3u);
    renderer->set_lights(garden.world.lights);
    EXPECT_EQ(drawn_frames(), 3u);
    std::vector<PlacedLight> more = garden.world.lights;
    more.push_back({garden.spot(0.6f, 5, 6), garden.at(0, 3, 0), {0, -1, 0}}); // the first spot
    renderer->set_lights(more);
    EXPECT_EQ(drawn_frames(), 4u);
    renderer->set_world(garden.world);
    EXPECT_EQ(drawn_frames(), 4u);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
