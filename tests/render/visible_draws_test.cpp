// What is not drawn never had a pixel, and how much that is.
#include "found_pixels.hpp"
#include "garden.hpp"
#include "random_scene.hpp"
#include <cmath>
#include <cstring>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

const SettingMap everything{{"draws", "direct"}, {"frustum-culling", "off"}, {"index-trimming", "off"}};

struct Drawn {
    Image final, depth;
    Stats stats;
};

Drawn drawn_with(const World& world, const PlacedCamera& camera, const SettingMap& settings,
                 const std::string& renderer = "light-prepass", Device& device = test_device(), uint32_t samples = 1) {
    const RenderOptions options{.width = 240, .height = 136, .msaa = samples, .settings = settings, .views = {"depth"}};
    const auto made = create_renderer(renderer, &device, options);
    made->set_world(world);
    made->render(camera);
    return {made->read("final"), made->read("depth"), made->stats()};
}

/// What is left out by hidden pixels, in both passes and by both means.
const SettingMap all_at_once{{"index-trimming", "device"}, {"material-trimming", "depth"}, {"occlusion", "queries"}};

/// Other ways to draw the same. The other architectures share the first pass's draws with the light pre-pass.
std::vector<SettingMap> ways_of(const std::string& renderer) {
    if (renderer == "light-prepass")
        return {{}, // the defaults
                {{"index-trimming", "host"}, {"draws", "direct"}},
                {{"index-trimming", "off"}, {"draws", "instanced"}},
                {{"index-trimming", "device"}},
                {{"index-trimming", "off"}, {"occlusion", "queries"}, {"draws", "direct"}},
                {{"index-trimming", "host"}, {"material-trimming", "depth"}},
                all_at_once};
    if (renderer == "z-prepass")
        return {{}, all_at_once};
    return {{{"index-trimming", "device"}}};
}

/// The same bytes however objects are drawn, for all architectures.
void expect_same_bytes(const World& world, const PlacedCamera& camera, Device& device = test_device()) {
    for (const char* renderer : {"light-prepass", "deferred", "z-prepass", "multipass"}) {
        const Drawn all = drawn_with(world, camera, everything, renderer, device);
        for (const SettingMap& way : ways_of(renderer)) {
            const Drawn ours = drawn_with(world, camera, way, renderer, device);
            std::string trace = renderer;
            for (const auto& [key, value] : way)
                trace += " " + key + "=" + value;
            SCOPED_TRACE(trace);
            EXPECT_TRUE(ours.final.pixels == all.final.pixels);
            EXPECT_TRUE(ours.depth.pixels == all.depth.pixels);
            EXPECT_LE(ours.stats.triangles_drawn, all.stats.triangles_drawn);
            EXPECT_EQ(all.stats.triangles_drawn, all.stats.triangles);
        }
    }
    expect_validation_clean(device);
}

PlacedCamera orthographic(const PlacedCamera& from) {
    PlacedCamera camera = from;
    camera.camera.kind = ProjectionKind::orthographic;
    camera.camera.ymag = 3;
    camera.camera.znear = 0.1f;
    camera.camera.zfar = 50;
    return camera;
}

TEST(VisibleDraws, CamerasOutsideInsideAndOrthographic) {
    Garden garden;
    garden.add_lights(4, 6, 8);
    uint64_t triangles = 0;
    for (const Mesh& mesh : garden.scene.meshes)
        triangles += mesh.primitives[0].indices.size() / 3;
    garden.world.triangles = triangles;
    const Camera lens = garden.camera.camera;
    for (const PlacedCamera& camera :
         {garden.camera, orthographic(garden.camera), look_at(lens, {0, 1, 0.8}, {0, 0.6, 5}), // inside a sphere
          look_at(lens, {0, 0.3, 2.1}, {2, 0.9, -1}),        // spheres beside and behind the camera
          look_at(lens, {-4.0, 1.02, 1.805}, {-4, 1, 0.8})}) // the near plane cuts one
        expect_same_bytes(garden.world, camera);
}

TEST(VisibleDraws, MaskedMirroredDoubleSidedUnlit) {
    MixedMaterials mixed;
    mixed.world.triangles = 2 * mixed.world.instances.size();
    const Shot shot = mixed.shot();
    expect_same_bytes(mixed.world, shot.camera);
    expect_same_bytes(mixed.world, look_at(shot.camera.camera, {0.3, 0.2, -4}, {0, 0, 0})); // from behind
}

/// Small triangles everywhere: 96 × 48 of them on each sphere, some pixels wide in the picture.
TEST(VisibleDraws, TrianglesBelowAPixel) {
    TestWorld test;
    test.add_material({.name = "clay", .base_colour = {0.8f, 0.3f, 0.2f, 1}, .metallic = 0, .roughness = 0.9f});
    test.add(sphere(96));
    for (int i = 1; i < 12; ++i)
        test.place(0, glm::scale(glm::translate(glm::dmat4(1), {2.2 * (i % 4) - 3.3, 2.2 * (i / 4) - 2.2, -0.7 * i}),
                                 glm::dvec3(i % 3 ? 1 : -1, 1, 1)));
    test.world.triangles = 12 * test.scene.meshes[0].primitives[0].indices.size() / 3;
    test.add_light({.kind = LightKind::directional, .intensity = 2}, {0, 0, 0}, {-0.3, -0.5, -1});
    for (const double distance : {9.0, 31.7, 140.3}) {
        expect_same_bytes(test.world, front_camera(distance));
        const Drawn ours = drawn_with(test.world, front_camera(distance), {});
        EXPECT_LT(2 * ours.stats.triangles_drawn, test.world.triangles) << "half of a sphere faces away";
        if (distance > 100) {
            EXPECT_LT(ours.stats.triangles_drawn, uint64_t(240 * 136)) << "more triangles than pixels";
        }
    }
}

/// Whole objects inside the picture, across each of its sides, around and behind the camera, too small for a pixel,
/// mirrored and flattened; with one sample a pixel and with several.
TEST(VisibleDraws, WholeObjects) {
    TestWorld test;
    test.add_material({.name = "clay", .base_colour = {0.8f, 0.3f, 0.2f, 1}, .metallic = 0, .roughness = 0.9f});
    test.add(sphere(32));
    const auto place = [&](const glm::dvec3& at, const glm::dvec3& size) {
        test.place(0, glm::scale(glm::translate(glm::dmat4(1), at), size));
    };
    for (const glm::dvec3& at : {glm::dvec3(-6.3, 0, 0), glm::dvec3(6.3, 1, 0), glm::dvec3(1, 3.6, 0),
                                 glm::dvec3(-1, -3.6, 0), glm::dvec3(0.2, 0.1, 9), glm::dvec3(0, 0, 20)})
        place(at, {1, 1, -1});
    for (int i = 0; i < 12; ++i)
        place({0.31 * i - 2, 2.2 - 0.13 * i, 0}, glm::dvec3(0.012));
    place({2.5, 0, 1}, {1, 1, 1e-6});
    test.world.triangles = test.world.instances.size() * test.scene.meshes[0].primitives[0].indices.size() / 3;
    test.add_light({.kind = LightKind::directional, .intensity = 2}, {0, 0, 0}, {-0.3, -0.5, -1});
    for (const PlacedCamera& camera : {front_camera(9), orthographic(front_camera(9))})
        for (const uint32_t samples : {1u, 4u}) {
            const Drawn all = drawn_with(test.world, camera, everything, "light-prepass", test_device(), samples);
            for (const char* trimming : {"host", "device"}) {
                const SettingMap settings{{"index-trimming", trimming}};
                const Drawn ours = drawn_with(test.world, camera, settings, "light-prepass", test_device(), samples);
                SCOPED_TRACE(std::to_string(samples) + " " + trimming);
                EXPECT_TRUE(ours.final.pixels == all.final.pixels);
                EXPECT_TRUE(ours.depth.pixels == all.depth.pixels);
                EXPECT_LT(ours.stats.triangles_drawn, all.stats.triangles_drawn);
                if (samples == 1) { // several samples lie in each triangle of what is small
                    EXPECT_LT(10 * ours.stats.triangles_drawn, 3 * all.stats.triangles_drawn);
                }
            }
        }
    expect_validation_clean(test_device());
}

/// Which way a triangle faces has nothing to do with where the samples are: half of the sphere is left out.
TEST(VisibleDraws, FacesAwayWithSeveralSamples) {
    TestWorld test;
    test.add_material({.name = "clay", .base_colour = {0.8f, 0.3f, 0.2f, 1}, .metallic = 0, .roughness = 0.9f});
    test.add(sphere(128));
    test.world.triangles = test.scene.meshes[0].primitives[0].indices.size() / 3;
    for (const char* trimming : {"host", "device"}) {
        const Drawn ours =
            drawn_with(test.world, front_camera(4), {{"index-trimming", trimming}}, "light-prepass", test_device(), 4);
        EXPECT_LT(100 * ours.stats.triangles_drawn, 55 * test.world.triangles) << trimming;
    }
}

/// What the device does not trim it does not count: blended objects here, which stand where opaque ones stood in the
/// frames before.
TEST(VisibleDraws, TheDeviceCountsWhatItTrims) {
    TestWorld test;
    test.add_material({.name = "clay", .base_colour = {0.8f, 0.3f, 0.2f, 1}, .metallic = 0, .roughness = 0.9f});
    test.add_material({.name = "veil", .base_colour = {0.2f, 0.3f, 0.8f, 0.5f}, .alpha_mode = AlphaMode::blend});
    test.add(sphere(32));
    for (int i = 1; i < 6; ++i)
        test.place(0, glm::translate(glm::dmat4(1), {0.5 * i, 0, 0}));
    Primitive veil = sphere(16);
    veil.material = 1;
    const uint64_t veil_triangles = veil.indices.size() / 3;
    test.scene.meshes.push_back({"veil", {std::move(veil)}});
    for (int i = 0; i < 4; ++i)
        test.place(1, glm::translate(glm::dmat4(1), {40 + 0.5 * i, 0, 0}));
    test.add_light({.kind = LightKind::directional, .intensity = 2}, {0, 0, 0}, {-0.3, -0.5, -1});
    const RenderOptions options{.width = 160, .height = 90, .settings = {{"index-trimming", "device"}}, .views = {}};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(test.world);
    for (int frame = 0; frame < 4; ++frame)
        renderer->render(front_camera(9));
    EXPECT_GT(renderer->stats().triangles_drawn, 6 * veil_triangles);
    const Camera lens = front_camera(9).camera;
    for (int frame = 0; frame < 2; ++frame) {
        renderer->render(look_at(lens, {41, 0, 9}, {41, 0, 0}));
        EXPECT_EQ(renderer->stats().triangles_drawn, 4 * veil_triangles);
    }
}

TEST(VisibleDraws, RandomScenes) {
    for (const uint64_t seed : {3u, 11u, 29u, 41u}) {
        SCOPED_TRACE(seed);
        RandomScene scene(seed);
        scene.world.triangles = 0;
        for (const Instance& instance : scene.world.instances)
            scene.world.triangles += scene.world.mesh_of(instance).primitives[0].indices.size() / 3;
        expect_same_bytes(scene.world, scene.camera);
    }
}

TEST(VisibleDraws, OnSwiftShadersCoarserGridOfPixels) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed";
    Garden garden;
    garden.add_lights(2, 6, 8);
    garden.world.triangles = 0;
    for (const Instance& instance : garden.world.instances)
        garden.world.triangles += garden.world.mesh_of(instance).primitives[0].indices.size() / 3;
    const Drawn all = drawn_with(garden.world, garden.camera, everything, "light-prepass", *device);
    const Drawn ours = drawn_with(garden.world, garden.camera, {}, "light-prepass", *device);
    EXPECT_TRUE(ours.final.pixels == all.final.pixels);
    EXPECT_LT(2 * ours.stats.triangles_drawn, all.stats.triangles_drawn);
    const Drawn by_device = drawn_with(garden.world, garden.camera, all_at_once, "light-prepass", *device);
    EXPECT_TRUE(by_device.final.pixels == all.final.pixels);
    EXPECT_LT(2 * by_device.stats.triangles_drawn, all.stats.triangles_drawn);
    EXPECT_EQ(by_device.stats.settings.at("occlusion"), "off") << "there is no conditional rendering";
    EXPECT_FALSE(by_device.stats.draws_skipped.has_value());
    ASSERT_EQ(by_device.stats.notes.size(), 1u);
    EXPECT_NE(by_device.stats.notes[0].find("VK_EXT_conditional_rendering"), std::string::npos);
    expect_validation_clean(*device);
}

/// 266 objects of three meshes; 50 of them are behind the camera or beside the picture.
TEST(VisibleDraws, CountsOfTheBaselineScene) {
    const Scene scene = make_scene("lights", 4, 1);
    const World world = resolve(scene);
    const auto stats = [&](SettingMap settings) { return drawn_with(world, world.cameras.at(0), settings).stats; };
    EXPECT_EQ(stats(everything).draws, 266u);
    EXPECT_EQ(stats(everything).triangles_drawn, world.triangles);
    const Stats culled = stats({{"draws", "direct"}, {"index-trimming", "off"}});
    EXPECT_LT(culled.draws, 230u);
    EXPECT_GT(culled.draws, 200u);
    EXPECT_EQ(stats({{"draws", "instanced"}, {"index-trimming", "off"}}).draws, 3u);
    EXPECT_EQ(stats({{"draws", "indirect"}, {"index-trimming", "off"}}).draws, 3u);
    const Stats trimmed = stats({{"index-trimming", "host"}});
    EXPECT_LE(trimmed.draws, culled.draws);
    EXPECT_LT(trimmed.triangles_drawn, world.triangles / 4);
    EXPECT_EQ(trimmed.settings.at("index-trimming"), "host");
    EXPECT_EQ(stats({}).settings.at("index-trimming"), "host") << "auto, on a software device";
}

/// The device trims as the host does, but for what their rounding leaves open.
TEST(VisibleDraws, TheDeviceLeavesOutWhatTheHostDoes) {
    const Scene scene = make_scene("lights", 4, 1);
    const World world = resolve(scene);
    const auto triangles = [&](const char* way) {
        const Stats stats = drawn_with(world, world.cameras.at(0), {{"index-trimming", way}}).stats;
        return static_cast<double>(stats.triangles_drawn);
    };
    const double host = triangles("host"), device = triangles("device");
    EXPECT_LT(host, 0.25 * static_cast<double>(world.triangles));
    EXPECT_NEAR(device, host, 0.002 * host);
}

/// Behind a wall, seen from in front: four spheres, and one that stands beside it.
struct Hidden : TestWorld {
    Hidden() {
        add_material({.name = "clay", .base_colour = {0.8f, 0.3f, 0.2f, 1}, .metallic = 0, .roughness = 0.9f});
        add(sphere(96)); // instance 0
        for (const double x : {-1.0, 1.0, 2.0})
            place(0, glm::translate(glm::dmat4(1), {x, 0, -3}));
        place(0, glm::translate(glm::dmat4(1), {9, 0, -8}));
        scene.meshes.push_back({"wall", {cube()}});
        place(1, glm::scale(glm::translate(glm::dmat4(1), {0.5, 0, 2}), glm::dvec3(2.6, 2, 0.1)));
        world.triangles = 5 * scene.meshes[0].primitives[0].indices.size() / 3 + 12;
        add_light({.kind = LightKind::directional, .intensity = 2}, {0, 0, 0}, {-0.3, -0.5, -1});
    }
};

TEST(VisibleDraws, HiddenObjectsAreNotDrawnAgain) {
    Hidden hidden;
    const PlacedCamera camera = front_camera(9);
    expect_same_bytes(hidden.world, camera);
    for (const char* renderer : {"light-prepass", "z-prepass"}) {
        const Stats stats = drawn_with(hidden.world, camera, {{"occlusion", "queries"}}, renderer).stats;
        EXPECT_EQ(stats.draws_skipped, 4u) << renderer;
        EXPECT_FALSE(stats.triangles_skipped.has_value());
        EXPECT_FALSE(drawn_with(hidden.world, camera, {}, renderer).stats.draws_skipped.has_value());
    }
    const PlacedCamera from_behind = look_at(camera.camera, {0, 0, -16}, {0, 0, 0});
    EXPECT_EQ(drawn_with(hidden.world, from_behind, {{"occlusion", "queries"}}).stats.draws_skipped, 0u)
        << "from behind all can be seen";
}

TEST(VisibleDraws, HiddenTrianglesAreNotDrawnAgain) {
    Hidden hidden;
    const PlacedCamera camera = front_camera(9);
    for (const char* renderer : {"light-prepass", "z-prepass"})
        for (const char* trimming : {"off", "host", "device"}) {
            const SettingMap settings{{"index-trimming", trimming}, {"material-trimming", "depth"}};
            const Stats stats = drawn_with(hidden.world, camera, settings, renderer).stats;
            ASSERT_TRUE(stats.triangles_skipped.has_value());
            // With all triangles sent, those that face away are left as well: they have no pixels to be seen at.
            EXPECT_GT(10 * *stats.triangles_skipped, 6 * stats.triangles_drawn) << renderer << " " << trimming;
            EXPECT_LT(*stats.triangles_skipped, stats.triangles_drawn);
        }
}

/// Where triangles of one object coincide, the order of its indices shows: more of them than a workgroup has.
TEST(VisibleDraws, TheDeviceKeepsTheOrder) {
    TestWorld test;
    test.add_material({.name = "paint", .base_colour = {1, 1, 1, 1}, .metallic = 0, .roughness = 0.9f, .unlit = true});
    Primitive pile;
    for (uint32_t i = 0; i < 2000;
         ++i) { // squares at 25 places, over and over in another colour; each third one faces away
        const float x = static_cast<float>(i % 5) - 2.5f, y = static_cast<float>(i / 5 % 5) - 2.5f;
        const uint32_t base = static_cast<uint32_t>(pile.positions.size());
        for (const glm::vec2& corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1)}) {
            pile.positions.emplace_back(x + corner.x, y + corner.y, 0);
            pile.normals.emplace_back(0, 0, 1);
            pile.colours.emplace_back(static_cast<float>(i * 37 % 256) / 255, static_cast<float>(i * 91 % 256) / 255,
                                      0.5f, 1);
        }
        for (const uint32_t corner : {0u, i % 3 ? 1u : 2u, i % 3 ? 2u : 1u})
            pile.indices.push_back(base + corner);
    }
    test.add(std::move(pile));
    test.world.triangles = 2000;
    expect_same_bytes(test.world, front_camera(6));
    const Stats stats = drawn_with(test.world, front_camera(6), {{"index-trimming", "device"}}).stats;
    EXPECT_EQ(stats.triangles_drawn, 1333u);
}

/// Frames in flight at once, and a camera that moves: nothing of the frame before shows.
TEST(VisibleDraws, MovingCamera) {
    Hidden hidden;
    const RenderOptions options{.width = 160, .height = 90, .settings = all_at_once, .views = {}};
    const auto moving = create_renderer("light-prepass", &test_device(), options);
    moving->set_world(hidden.world);
    const Camera lens = front_camera(9).camera;
    for (int i = 0; i < 6; ++i)
        moving->render(look_at(lens, {2.0 * i - 5, 1, 9}, {0, 0, 0}));
    const PlacedCamera last = look_at(lens, {5, 1, 9}, {0, 0, 0});
    const auto once = create_renderer("light-prepass", &test_device(), options);
    once->set_world(hidden.world);
    once->render(last);
    EXPECT_TRUE(moving->read("final").pixels == once->read("final").pixels);
    EXPECT_EQ(moving->stats().draws_skipped, once->stats().draws_skipped);
    EXPECT_EQ(moving->stats().triangles_skipped, once->stats().triangles_skipped);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
