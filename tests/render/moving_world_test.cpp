// A world that changes where it stands, told to a renderer that is kept: what a new renderer draws of the same state,
// at the cost of what changed.
#include "every_way.hpp"
#include "stage.hpp"
#include "vulkan_calls.hpp"
#include <prelight/error.hpp>

namespace prelight {
namespace {

Image picture_of(Renderer& renderer, const PlacedCamera& camera) {
    renderer.render(camera);
    return renderer.read("linear");
}

/// Draws `steps` states of the stage, each made of the one before, with a renderer that is told of the changes.
void expect_as_new(const Shot& shot, Stage& stage, int steps) {
    const auto kept = create_renderer(shot.renderer, &test_device(), options_of(shot));
    kept->set_world(stage.world);
    for (int step = 0; step < steps; ++step) {
        if (step > 0)
            kept->update_world(stage.change_in_place());
        if (step % 2 == 1) // several changes before a frame
            kept->update_world(stage.change_in_place());
        const auto fresh = create_renderer(shot.renderer, &test_device(), options_of(shot));
        fresh->set_world(stage.world);
        const Image expected = picture_of(*fresh, stage.camera);
        kept->render(stage.camera, 1 + static_cast<uint32_t>(step % 2));
        const Image image = kept->read("linear");
        size_t off = 0;
        for (size_t i = 0; i < image.pixels.size(); ++i)
            off += image.pixels[i] != expected.pixels[i];
        ASSERT_EQ(off, 0u) << "pixels, step " << step;
    }
}

class MovingWorld : public testing::TestWithParam<Shot> {};

INSTANTIATE_TEST_SUITE_P(All, MovingWorld, testing::ValuesIn(every_way({.width = 64, .height = 36})), way_name);

TEST_P(MovingWorld, DrawsWhatANewRendererDraws) {
    Stage stage(seed_of(GetParam()) + 7);
    expect_as_new(GetParam(), stage, 5);
    expect_validation_clean(test_device());
}

TEST_P(MovingWorld, ShadowsMoveToo) {
    Shot shot = GetParam();
    shot.settings.insert({{"shadows", "on"}, {"shadow-filter", "hard"}, {"shadow-budget", "262144"}});
    Stage stage(seed_of(GetParam()) + 8);
    expect_as_new(shot, stage, 5);
    expect_validation_clean(test_device());
}

TEST(MovingWorlds, DecalsLieOnWhatMovesUnderThem) {
    for (const char* name : {"light-prepass", "deferred", "multipass", "z-prepass"}) {
        SCOPED_TRACE(name);
        Stage stage(3);
        stage.add_material({.name = "paint", .base_colour = {1, 0, 0, 1}});
        PlacedDecal decal{.decal = {.material = static_cast<uint32_t>(stage.scene.materials.size() - 1)}};
        decal.transform = glm::scale(glm::rotate(glm::dmat4(1), -1.5707963267948966, {1, 0, 0}), glm::dvec3(2, 2, 3));
        stage.world.decals.push_back(decal);
        expect_as_new({.width = 96, .height = 54, .renderer = name}, stage, 8);
    }
    expect_validation_clean(test_device());
}

/// Spheres in a square, of which some move.
struct Crowd : TestWorld {
    explicit Crowd(uint32_t side) {
        add(sphere(6));
        world.instances.clear();
        for (uint32_t i = 0; i < side * side; ++i)
            place(0, glm::translate(glm::dmat4(1), {1.5 * (i % side), 0, 1.5 * (i / side)}));
        world.ambient = glm::vec3(0.1f);
        Light lamp{.kind = LightKind::point, .intensity = 40, .range = 20};
        add_light(lamp, {0.5 * side, 3, 0.5 * side});
    }
    PlacedCamera camera() const {
        const double side = std::sqrt(double(world.instances.size()));
        return look_at({.yfov = 1}, {-1, 4, -1}, {0.7 * side, 0, 0.7 * side});
    }
};

TEST(MovingWorlds, ASteadyMoveMakesNothingAndUploadsWhatMoved) {
    Crowd crowd(12);
    const RenderOptions options{
        .width = 64,
        .height = 36,
        .settings = {{"shadows", "on"}, {"shadow-budget", "262144"}, {"index-trimming", "off"}}};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(crowd.world);
    const auto move = [&](uint32_t count, double by) {
        WorldChanges changes;
        for (uint32_t i = 49; i < 49 + count; ++i) { // inside of the crowd: the world's box stays
            crowd.world.instances[i].transform[3].x += by;
            changes.instances.push_back(i);
        }
        renderer->update_world(changes);
        renderer->render(crowd.camera());
        return renderer->stats();
    };
    for (int warm = 0; warm < 3; ++warm)
        move(10, 0.01);
    VulkanCalls calls;
    const Stats ten = move(10, 0.01), none = move(0, 0), one = move(1, 0.01);
    EXPECT_EQ(calls.images + calls.buffers, 0u);
    EXPECT_EQ(ten.created, CreatedObjects{});
    EXPECT_EQ(none.updated_bytes, 0u);
    EXPECT_EQ(one.updated_bytes, 48u) << "one row of a caster";
    EXPECT_EQ(ten.updated_bytes, 480u);
    EXPECT_EQ(ten.frame_bytes, one.frame_bytes) << "records of what is visible";
    crowd.scene.materials[0].roughness = 0.3f;
    renderer->update_world({.materials = {0}});
    renderer->render(crowd.camera());
    const Stats painted = renderer->stats();
    EXPECT_EQ(painted.created, CreatedObjects{});
    EXPECT_GT(painted.updated_bytes, 0u);
    EXPECT_LT(painted.updated_bytes, 1024u);
    expect_validation_clean(test_device());
}

TEST(MovingWorlds, LightsThatStayAreNotWrittenAgain) {
    Crowd crowd(3);
    for (int i = 0; i < 99; ++i) {
        crowd.world.lights.push_back(crowd.world.lights[0]);
        crowd.world.lights.back().position.x += 0.01 * i;
    }
    // Trimmed indices are among the bytes, and a camera's millimetre may change them.
    const auto renderer = create_renderer("light-prepass", &test_device(),
                                          {.width = 64, .height = 36, .settings = {{"index-trimming", "off"}}});
    renderer->set_world(crowd.world);
    PlacedCamera camera = crowd.camera();
    const auto bytes = [&] {
        renderer->render(camera);
        return renderer->stats().frame_bytes;
    };
    for (int warm = 0; warm < 3; ++warm)
        bytes();
    const uint64_t still = bytes();
    EXPECT_EQ(bytes(), still);
    camera.position.y += 0.001;
    EXPECT_EQ(bytes(), still + 100 * 12) << "positions are relative to the camera";
    EXPECT_EQ(bytes(), still + 100 * 12) << "in the other frame's records too";
    EXPECT_EQ(bytes(), still);
    renderer->update_world({.lights = true});
    EXPECT_EQ(bytes(), still + 100 * 64);
    expect_validation_clean(test_device());
}

TEST(MovingWorlds, AMirrorThatFlipsIsAMove) {
    Crowd crowd(6);
    const RenderOptions options{
        .width = 64, .height = 36, .settings = {{"shadows", "on"}, {"shadow-budget", "262144"}}};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(crowd.world);
    const auto flip = [&] {
        Instance& instance = crowd.world.instances[14];
        instance.transform = instance.transform * glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
        instance.mirrored = !instance.mirrored;
        renderer->update_world({.instances = {14}});
        renderer->render(crowd.camera());
        return renderer->stats();
    };
    for (int warm = 0; warm < 3; ++warm)
        flip();
    const Stats stats = flip();
    EXPECT_EQ(stats.created, CreatedObjects{});
    EXPECT_EQ(stats.updated_bytes, 48u) << "one row of a caster";
    expect_validation_clean(test_device());
}

TEST(MovingWorlds, WhatIsNotThereIsRefused) {
    Crowd crowd(2);
    for (const char* name : {"light-prepass", "reference"}) {
        const auto renderer = create_renderer(name, &test_device(), {.width = 16, .height = 9});
        EXPECT_THROW(renderer->update_world({}), Error) << "before set_world()";
    }
    const auto renderer = create_renderer("light-prepass", &test_device(), {.width = 16, .height = 9});
    renderer->set_world(crowd.world);
    const WorldChanges wrong[] = {{.instances = {4}}, {.deformed = {0}}, {.materials = {1}}};
    for (const WorldChanges& changes : wrong) {
        EXPECT_THROW(renderer->update_world(changes), Error);
        EXPECT_THROW(renderer->render(crowd.camera()), Error) << "it has no world";
        renderer->set_world(crowd.world);
        renderer->render(crowd.camera());
        EXPECT_EQ(renderer->read("final").width, 16u);
    }
}

} // namespace
} // namespace prelight
