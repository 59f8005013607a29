// A world that moves in place is at any moment what resolve() gives for it, and tells what has changed.
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/scene_io.hpp>
#include <prelight/timeline.hpp>

using namespace prelight;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

void expect_same(const World& a, const World& b) {
    ASSERT_EQ(a.instances.size(), b.instances.size());
    for (size_t i = 0; i < a.instances.size(); ++i) {
        EXPECT_EQ(a.instances[i].transform, b.instances[i].transform) << i;
        EXPECT_EQ(a.instances[i].previous_transform, b.instances[i].previous_transform) << i;
        EXPECT_EQ(a.instances[i].mirrored, b.instances[i].mirrored) << i;
        EXPECT_EQ(a.instances[i].deformed, b.instances[i].deformed) << i;
    }
    EXPECT_EQ(a.deformations, b.deformations);
    ASSERT_EQ(a.deformed.size(), b.deformed.size());
    for (size_t d = 0; d < a.deformed.size(); ++d)
        for (size_t p = 0; p < a.deformed[d].primitives.size(); ++p) {
            EXPECT_EQ(a.deformed[d].primitives[p].positions, b.deformed[d].primitives[p].positions) << d;
            EXPECT_EQ(a.deformed[d].primitives[p].normals, b.deformed[d].primitives[p].normals) << d;
        }
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (size_t l = 0; l < a.lights.size(); ++l) {
        EXPECT_EQ(a.lights[l].position, b.lights[l].position) << l;
        EXPECT_EQ(a.lights[l].light, b.lights[l].light) << l;
    }
    ASSERT_EQ(a.cameras.size(), b.cameras.size());
    for (size_t c = 0; c < a.cameras.size(); ++c)
        EXPECT_EQ(a.cameras[c].position, b.cameras[c].position) << c;
    EXPECT_EQ(a.bounds_min, b.bounds_min);
    EXPECT_EQ(a.bounds_max, b.bounds_max);
}

TEST(Timeline, IsWhatResolveGivesWhateverCameBefore) {
    for (const char* name : {"motion", "city-sparks"}) {
        SCOPED_TRACE(name);
        const Scene scene = make_scene(name, 12, 1);
        Timeline timeline(scene);
        const World* const world = &timeline.world();
        expect_same(*world, resolve(scene));
        for (const double time : {0.5, 2.0, 0.5, 0.0}) {
            SCOPED_TRACE(time);
            timeline.move_to({time, 1.0 / 30});
            EXPECT_EQ(&timeline.world(), world);
            expect_same(*world, resolve(scene, {}, Moment{time, 1.0 / 30}));
        }
    }
}

TEST(Timeline, TellsWhatHasChanged) {
    Scene scene;
    scene.materials.emplace_back();
    Primitive triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.normals.assign(3, {0, 0, 1});
    triangle.indices = {0, 1, 2};
    scene.meshes.push_back({"mesh", {triangle}});
    scene.lights.emplace_back();
    scene.nodes.resize(3);
    for (uint32_t i = 0; i < 3; ++i)
        scene.nodes[i].trs = Trs{};
    scene.nodes[0].mesh = scene.nodes[1].mesh = 0;
    scene.nodes[2].light = 0;
    scene.scenes.push_back({"", {0, 1, 2}});
    scene.animations.push_back(
        {"", {{{0, 1}, {0, 0, 0, 1, 0, 0}, Interpolation::linear}}, {{0, 1, AnimationPath::translation}}});
    Timeline timeline(scene);
    EXPECT_TRUE(timeline.moves());
    EXPECT_TRUE(timeline.move_to({0}).empty());
    const WorldChanges changes = timeline.move_to({0.5});
    EXPECT_FALSE(changes.all);
    EXPECT_THAT(changes.instances, ElementsAre(1));
    EXPECT_FALSE(changes.lights);
    EXPECT_TRUE(timeline.move_to({0.5}).empty()) << "the same moment";
    EXPECT_THAT(timeline.move_to({0.5, 0.25}).instances, ElementsAre(1)) << "it came from elsewhere";
    EXPECT_EQ(timeline.world().instances[1].previous_transform.value()[3].x, 0.25);
    scene.animations[0].channels[0].node = 2;
    EXPECT_TRUE(Timeline(scene).move_to({0.5}).lights);
    scene.animations.clear();
    EXPECT_FALSE(Timeline(scene).moves());
}

// Without vertices on the host, boxes stand for them: no vertex lies outside.
TEST(Timeline, BoxesHoldAllThatIsDeformed) {
    std::vector<Scene> scenes;
    scenes.push_back(make_scene("motion", 12, 1));
    const std::filesystem::path folder = PRELIGHT_SHARED_SCENES;
    for (const char* name : {"Fox.glb", "CesiumMan.glb", "MorphStressTest.glb", "RecursiveSkeletons.glb"})
        if (std::filesystem::exists(folder / name))
            scenes.push_back(load_gltf(folder / name));
    for (const Scene& scene : scenes) {
        SCOPED_TRACE(scene.name);
        Timeline boxes(scene, {}, {}, {}, false);
        for (const double time : {0.3, 0.9, 1.7}) {
            const World whole = resolve(scene, {}, Moment{time, 0.1});
            boxes.move_to({time, 0.1});
            ASSERT_EQ(boxes.world().deformations, whole.deformations) << "the same shapes";
            double tight = 0;
            for (size_t d = 0; d < whole.deformed.size(); ++d) {
                const Deformation& shape = whole.deformations[d];
                if (!shape.mesh)
                    continue;
                EXPECT_THAT(boxes.world().deformed[d].primitives, IsEmpty());
                glm::vec3 low(1e30f), high(-1e30f);
                for (const Primitive& primitive : whole.deformed[d].primitives)
                    for (const uint32_t index : primitive.indices) {
                        low = glm::min(low, primitive.positions[index]);
                        high = glm::max(high, primitive.positions[index]);
                    }
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_LE(shape.low[axis], low[axis]);
                    EXPECT_GE(shape.high[axis], high[axis]);
                }
                tight = std::max(tight, double(glm::distance(low, high) / glm::distance(shape.low, shape.high)));
            }
            EXPECT_GT(tight, 0.3) << "and not all the world";
        }
    }
}

} // namespace
