// Skins and morph targets that the device bends, against the host's: the same world without its deformations is drawn
// with the vertices that resolve() made.
#include "every_way.hpp"
#include "random_scene.hpp"
#include "vulkan_calls.hpp"
#include <filesystem>
#include <prelight/scene_io.hpp>
#include <prelight/timeline.hpp>
#include <scene/procedural/random.hpp>

namespace prelight {
namespace {

World on_host(World world) {
    world.deformations.clear();
    return world;
}

void expect_as_on_host(const World& world, Shot shot) {
    ASSERT_FALSE(world.deformations.empty());
    const World host = on_host(world);
    shot.world = &world;
    const Image device_picture = render_linear(test_device(), shot);
    shot.world = &host;
    const Comparison off = compare_pixels(device_picture, render_linear(test_device(), shot));
    EXPECT_GT(off.psnr, 55) << name_of(shot);
    EXPECT_LT(off.off_share, 0.001) << name_of(shot);
}

/// A tube of `rings` × 8 vertices along x that follows four joints, with two morph targets; flat or smooth, with a
/// normal map's tangents.
Scene tube(uint64_t seed, bool flat, bool mirrored) {
    Random random(seed);
    Scene scene;
    scene.name = "tube";
    scene.materials.push_back({.name = "blue", .base_colour = {0.2, 0.4, 0.9, 1}, .metallic = 0, .roughness = 0.4});
    Primitive p;
    constexpr uint32_t rings = 16, around = 8;
    const auto vertex = [&](uint32_t r, uint32_t a) {
        const double angle = 6.283185307179586 * a / around;
        const glm::vec3 normal(0, std::cos(angle), std::sin(angle));
        p.positions.push_back(glm::vec3(4.0 * r / (rings - 1), 0, 0) + 0.4f * normal);
        p.normals.push_back(normal);
        p.tangents.emplace_back(1, 0, 0, 1);
    };
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t a = 0; a < around; ++a)
            vertex(r, a);
    for (uint32_t r = 0; r + 1 < rings; ++r)
        for (uint32_t a = 0; a < around; ++a) {
            const uint32_t b = (a + 1) % around, at = r * around, next = at + around;
            for (const uint32_t i : {at + a, next + b, next + a, at + a, at + b, next + b})
                p.indices.push_back(i);
        }
    if (flat) {
        Primitive corners;
        for (const uint32_t i : p.indices) {
            corners.positions.push_back(p.positions[i]);
            corners.indices.push_back(static_cast<uint32_t>(corners.indices.size()));
        }
        corners.normals.assign(corners.positions.size(), {0, 0, 1});
        corners.flat_normals = true;
        p = corners;
    }
    p.joint_sets.resize(2);
    for (JointSet& set : p.joint_sets)
        for (const glm::vec3& position : p.positions) {
            const float along = std::clamp(position.x, 0.f, 3.99f);
            const auto joint = static_cast<uint16_t>(std::min(along, 2.99f));
            const float share = along - static_cast<float>(joint);
            set.joints.push_back({joint, joint + 1, 0, 0});
            set.weights.push_back({0.5f * (1 - share), 0.5f * share, 0, 0});
        }
    p.morph_targets.resize(2);
    for (MorphTarget& target : p.morph_targets)
        for (size_t v = 0; v < p.positions.size(); ++v) {
            target.positions.emplace_back(0, 0.3 * std::sin(double(p.positions[v].x) * random.uniform(1, 1.1)), 0.1);
            target.normals.emplace_back(random.uniform(-0.2, 0.2), 0, 0);
        }
    scene.meshes.push_back({"tube", {p}, {0.3f, -0.5f}});
    scene.nodes.resize(5);
    scene.scenes.push_back({"", {0, 1}});
    scene.nodes[0].mesh = 0;
    scene.nodes[0].skin = 0;
    Skin skin{.name = "skin"};
    for (uint32_t j = 0; j < 4; ++j) {
        Node& joint = scene.nodes[1 + j];
        const double turn = random.uniform(-0.6, 0.6);
        joint.trs = Trs{{j == 0 ? 0.0 : 1.0, 0, 0}, glm::angleAxis(turn, glm::dvec3(0, 0.6, 0.8))};
        if (mirrored && j == 0)
            joint.trs->scale = {1, 1, -1};
        joint.local = joint.trs->matrix();
        if (j < 3)
            joint.children = {2 + j};
        skin.joints.push_back(1 + j);
        skin.inverse_bind.push_back(glm::translate(glm::dmat4(1), {-double(j), 0, 0}));
    }
    scene.skins.push_back(skin);
    scene.animations.push_back({"bend",
                                {{{0, 1}, {0, 0, 0, 1, 0, 0.6, 0, 0.8}, Interpolation::linear},
                                 {{0, 1}, {0, 0, 1, -1}, Interpolation::linear}},
                                {{0, 3, AnimationPath::rotation}, {1, 0, AnimationPath::weights}}});
    return scene;
}

TEST(Deformation, TheDeviceBendsAsTheHost) {
    for (const bool flat : {false, true})
        for (const bool mirrored : {false, true}) {
            SCOPED_TRACE(flat ? "flat" : "smooth");
            SCOPED_TRACE(mirrored ? "mirrored" : "as it is");
            const Scene scene = tube(flat + 2 * mirrored, flat, mirrored);
            const World world = resolve(scene, {}, Moment{0.7, 0.1});
            EXPECT_EQ(world.deformations.at(0).turned, mirrored);
            for (const char* renderer : {"light-prepass", "multipass"})
                expect_as_on_host(world, {.camera = world.cameras[0], .renderer = renderer});
        }
    expect_validation_clean(test_device());
}

TEST(Deformation, MotionVectorsKnowWhereVerticesWere) {
    const Scene scene = tube(5, false, false);
    const World world = resolve(scene, {}, Moment{0.6, 0.2}), host = on_host(world);
    Shot shot{.world = &world, .camera = world.cameras[0], .renderer = "deferred"};
    const Image device_motion = view_of(shot, "motion");
    shot.world = &host;
    EXPECT_GT(compare_pixels(device_motion, view_of(shot, "motion")).psnr, 45);
    const World still = resolve(scene, {}, Moment{0.6});
    shot.world = &still;
    EXPECT_LT(compare_pixels(device_motion, view_of(shot, "motion")).psnr, 30) << "it does move";
}

TEST(Deformation, RealModelsAreTheSame) {
    const std::filesystem::path folder = PRELIGHT_SHARED_SCENES;
    if (!std::filesystem::exists(folder / "Fox.glb"))
        GTEST_SKIP() << "no shared scenes beside the repository";
    for (const char* name : {"Fox.glb", "CesiumMan.glb", "MorphStressTest.glb", "RecursiveSkeletons.glb"}) {
        SCOPED_TRACE(name);
        const Scene scene = load_gltf(folder / name);
        const World world = resolve(scene, {}, Moment{0.4});
        expect_as_on_host(world,
                          {.camera = world.cameras[0], .settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}}});
    }
    expect_validation_clean(test_device());
}

/// The tube's skin is turned inside out after half a second, and back.
Scene flipping() {
    Scene scene = tube(4, true, false);
    scene.nodes[1].trs->scale = {1, 1, 1};
    scene.animations[0].samplers.push_back({{0, 0.5, 0.85}, {1, 1, 1, 1, 1, -1, 1, 1, 1}, Interpolation::step});
    scene.animations[0].channels.push_back({2, 1, AnimationPath::scale});
    return scene;
}

/// Tubes without skins whose weights come from 0 and go there again, beside each other's, and one in a mirror.
Scene swelling() {
    Scene scene = tube(6, false, false);
    scene.skins.clear();
    scene.meshes[0].primitives[0].joint_sets.clear();
    scene.meshes[0].weights.clear();
    scene.nodes.assign(3, {});
    scene.scenes[0].nodes = {0, 1, 2};
    for (uint32_t i = 0; i < 3; ++i) {
        scene.nodes[i].mesh = 0;
        scene.nodes[i].trs = Trs{{0, 1.2 * i, 0}};
        scene.nodes[i].local = scene.nodes[i].trs->matrix();
    }
    scene.animations = {{"swell",
                         {{{0.3, 0.6, 0.9}, {0, 0, 0.8f, -0.5f, 0, 0}, Interpolation::linear},
                          {{0.3, 0.8}, {0.8f, 0, 0, 0}, Interpolation::step},
                          {{0, 0.5}, {1, 1, 1, -1, 1, 1}, Interpolation::step}},
                         {{0, 0, AnimationPath::weights},
                          {0, 1, AnimationPath::weights},
                          {1, 2, AnimationPath::weights},
                          {2, 1, AnimationPath::scale}}}};
    return scene;
}

TEST(Deformation, WeightsThatBecomeZeroAndMirrorsThatFlipMakeNothing) {
    for (const Scene& scene : {swelling(), flipping()}) {
        Timeline timeline(scene, {}, Moment{0.1}, {}, false);
        const auto renderer = create_renderer("deferred", &test_device(), {.width = 64, .height = 36});
        renderer->set_world(timeline.world());
        const PlacedCamera camera = timeline.world().cameras[0];
        const auto step = [&](double time) {
            const WorldChanges changes = timeline.move_to({time, 0.01});
            EXPECT_FALSE(changes.all) << time;
            renderer->update_world(changes);
            renderer->render(camera);
            return renderer->stats();
        };
        constexpr double times[] = {0.1, 0.45, 0.3, 0.7, 0.95};
        for (int round = 0; round < 2; ++round) // both frames in flight have staged the most that a step needs
            for (const double time : times)
                step(time);
        for (const double time : times) {
            const Stats stats = step(time);
            EXPECT_EQ(stats.created, CreatedObjects{}) << time;
            EXPECT_GT(stats.updated_bytes, 0u) << time;
            EXPECT_LT(stats.updated_bytes, 1024u) << time;
        }
    }
    expect_validation_clean(test_device());
}

// Moments one after the other, in any order, in one renderer: the bytes of a new one.
TEST(Deformation, MomentsAreThoseOfANewRenderer) {
    const Scene bent = tube(9, false, false), motion = make_scene("motion", 12, 1), flipped = flipping(),
                swollen = swelling();
    for (const Scene* scene : {&bent, &motion, &flipped, &swollen})
        for (const char* name : {"light-prepass", "deferred"}) {
            SCOPED_TRACE(name);
            const RenderOptions options{.width = 96,
                                        .height = 54,
                                        .settings = {{"shadows", "on"}, {"shadow-budget", "1048576"}},
                                        .views = {"linear"}};
            Timeline timeline(*scene, {}, Moment{0.1, 0.05}, {}, false);
            const auto kept = create_renderer(name, &test_device(), options);
            kept->set_world(timeline.world());
            for (const double time : {0.3, 0.9, 0.35, 0.0, 0.8}) {
                SCOPED_TRACE(time);
                kept->update_world(timeline.move_to({time, 0.05}));
                const PlacedCamera& camera = timeline.world().cameras[0];
                kept->render(camera);
                const World whole = resolve(*scene, {}, Moment{time, 0.05});
                const auto fresh = create_renderer(name, &test_device(), options);
                fresh->set_world(whole);
                fresh->render(camera);
                ASSERT_EQ(kept->read("linear").pixels, fresh->read("linear").pixels);
            }
        }
    expect_validation_clean(test_device());
}

TEST(Deformation, ASteadyWalkMakesNothingAndUploadsJoints) {
    const Scene scene = tube(3, false, false);
    Timeline timeline(scene, {}, Moment{0.1}, {}, false);
    const auto renderer = create_renderer("deferred", &test_device(), {.width = 64, .height = 36});
    renderer->set_world(timeline.world());
    const PlacedCamera camera = timeline.world().cameras[0];
    const auto step = [&](double time) {
        renderer->update_world(timeline.move_to({time, 0.1}));
        renderer->render(camera);
        return renderer->stats();
    };
    for (const double time : {0.2, 0.3, 0.4})
        step(time);
    VulkanCalls calls;
    const Stats stats = step(0.5);
    EXPECT_EQ(calls.buffers + calls.images + calls.pipelines + calls.allocations, 0u);
    EXPECT_EQ(stats.created, CreatedObjects{});
    EXPECT_EQ(stats.updated_bytes, 4 * 2 * 48u + 2 * 16u) << "four joints and two weights, now and before";
    EXPECT_EQ(step(0.5).updated_bytes, 0u) << "nothing moved";
}

} // namespace
} // namespace prelight
