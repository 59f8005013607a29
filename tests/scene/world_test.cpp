#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <prelight/error.hpp>
#include <prelight/framing.hpp>
#include <prelight/scene.hpp>
#include <scene/near.hpp>

using namespace prelight;
using prelight::test::expect_near;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

/// A scene of one node with a box of `size` (its 8 corners, two triangles through them).
Scene box(glm::vec3 size = glm::vec3(1)) {
    Scene scene;
    scene.name = "box";
    Primitive p;
    for (uint32_t i = 0; i < 8; ++i)
        p.positions.push_back(size * glm::vec3(i & 1, i >> 1 & 1, i >> 2));
    p.normals.assign(8, glm::vec3(0, 0, 1));
    p.indices = {0, 1, 2, 3, 4, 5, 6, 7, 0};
    scene.materials.emplace_back();
    scene.meshes.push_back({"box", {p}});
    scene.nodes.emplace_back().mesh = 0;
    scene.scenes.push_back({"", {0}});
    return scene;
}

TEST(Resolve, WalksDepthFirstInDouble) {
    Scene scene = box();
    scene.nodes.resize(4);
    scene.nodes[0].children = {2, 1};
    scene.nodes[2].children = {3};
    for (uint32_t i = 1; i < 4; ++i)
        scene.nodes[i].mesh = 0;
    scene.nodes[0].local = glm::translate(glm::dmat4(1), glm::dvec3(10'000, 0, 0.001));
    scene.nodes[2].local = glm::scale(glm::dmat4(1), glm::dvec3(2));
    scene.nodes[3].local = glm::translate(glm::dmat4(1), glm::dvec3(1, 0, 0));
    const World world = resolve(scene);
    ASSERT_THAT(world.instances, SizeIs(4));
    const std::vector<uint32_t> order = {0, 2, 3, 1};
    for (size_t i = 0; i < 4; ++i)
        EXPECT_EQ(world.instances[i].node, order[i]);
    expect_near(world.instances[2].transform[3], {10'002, 0, 0.001}, 1e-9);
    EXPECT_EQ(world.triangles, 12u);
    expect_near(world.bounds_min, {10'000, 0, 0.001}, 1e-9);
    expect_near(world.bounds_max, {10'004, 2, 2.001}, 1e-9);
}

TEST(Resolve, BoundsAreOfTheTrianglesVerticesOnly) {
    Scene scene = box();
    scene.meshes[0].primitives[0].positions.push_back(glm::vec3(1000)); // no triangle uses it
    const double c = std::sqrt(0.5);
    scene.nodes[0].local = glm::dmat4(c, c, 0, 0, -c, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    const World world = resolve(scene); // a box about the turned box would reach √2 too far
    expect_near(world.bounds_min, {-c, 0, 0}, 1e-12);
    expect_near(world.bounds_max, {c, 2 * c, 1}, 1e-12);
}

TEST(Resolve, VeryManyInstancesOfVeryManyVerticesFallBackToBoxes) {
    // Found by fuzzing: 50,000 instances of 50,000 vertices.
    Scene scene = box();
    Primitive& p = scene.meshes[0].primitives[0];
    p.positions.resize(50'000, glm::vec3(0.5f));
    p.indices.resize(150'000);
    for (uint32_t i = 0; i < 150'000; ++i)
        p.indices[i] = i % 50'000;
    scene.nodes[0].instances.assign(50'000, glm::dmat4(1));
    scene.nodes[0].instances.back()[3].x = 10;
    const auto start = std::chrono::steady_clock::now();
    const World world = resolve(scene);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    expect_near(world.bounds_min, {0, 0, 0}, 1e-12);
    expect_near(world.bounds_max, {11, 1, 1}, 1e-12);
}

TEST(Resolve, NegativeScaleMirrorsAndWhatHasNoAreaIsDropped) {
    Scene scene = box();
    scene.nodes.resize(6, scene.nodes[0]);
    scene.scenes[0].nodes = {0, 1, 2, 3, 4, 5};
    scene.nodes[1].local = glm::scale(glm::dmat4(1), glm::dvec3(-1, 2, 3));
    scene.nodes[2].local = glm::scale(glm::dmat4(1), glm::dvec3(-1, -2, 3));
    scene.nodes[3].local = glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 0)); // a line
    scene.nodes[4].local = glm::scale(glm::dmat4(1), glm::dvec3(-1e-150)); // its determinant underflows
    scene.nodes[5].local = glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1)); // flat, but seen
    const World world = resolve(scene);
    ASSERT_THAT(world.instances, SizeIs(5));
    EXPECT_FALSE(world.instances[0].mirrored);
    EXPECT_TRUE(world.instances[1].mirrored);
    EXPECT_FALSE(world.instances[2].mirrored);
    EXPECT_EQ(world.instances[3].node, 4u);
    EXPECT_TRUE(world.instances[3].mirrored);
    EXPECT_EQ(world.instances[4].node, 5u);
    EXPECT_FALSE(world.instances[4].mirrored);
}

TEST(Resolve, LightsShineAlongMinusZWithoutScale) {
    Scene scene = box();
    Light spot;
    spot.kind = LightKind::spot;
    spot.range = 7;
    scene.lights.push_back(spot);
    scene.nodes.emplace_back().light = 0;
    scene.scenes[0].nodes = {0, 1};
    // x → z, y → y, z → −x, each scaled by another factor.
    scene.nodes[1].local = glm::dmat4(0, 0, 2, 0, 0, 3, 0, 0, -5, 0, 0, 0, 1, 2, 3, 1);
    const World world = resolve(scene);
    ASSERT_THAT(world.lights, SizeIs(1));
    expect_near(world.lights[0].position, {1, 2, 3}, 1e-12);
    expect_near(world.lights[0].direction, {1, 0, 0}, 1e-12);
    EXPECT_EQ(world.lights[0].light.range, 7);
    EXPECT_EQ(world.ambient, glm::vec3(0)); // it has a light, so no default comes in
}

TEST(Resolve, CameraAxesAreOrthonormal) {
    Scene scene = box();
    scene.cameras.emplace_back().name = "skewed";
    scene.nodes.emplace_back().camera = 0;
    scene.scenes[0].nodes = {0, 1};
    scene.nodes[1].local = glm::dmat4(-2, 0, 0, 0, 0.5, 3, 1, 0, 0, 0, 4, 0, 1, 2, 3, 1);
    const World world = resolve(scene);
    ASSERT_THAT(world.cameras, SizeIs(1));
    const glm::dmat3 axes = world.cameras[0].axes;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(glm::dot(axes[i], axes[k]), i == k ? 1 : 0, 1e-12);
    EXPECT_NEAR(glm::determinant(axes), 1, 1e-12);
    expect_near(axes[2], {0, 0, 1}, 1e-12);
    expect_near(world.cameras[0].position, {1, 2, 3}, 1e-12);
}

TEST(Resolve, DefaultsWhenThereIsNeitherCameraNorLight) {
    const World world = resolve(box());
    ASSERT_THAT(world.lights, SizeIs(1));
    EXPECT_EQ(world.lights[0].light.kind, LightKind::directional);
    EXPECT_EQ(world.lights[0].light.intensity, 3);
    expect_near(world.lights[0].direction, glm::normalize(glm::dvec3(-0.4, -0.8, -0.45)), 1e-12);
    EXPECT_EQ(world.ambient, glm::vec3(0.25f));
    ASSERT_THAT(world.cameras, SizeIs(1));
    EXPECT_EQ(world.cameras[0].camera.name, "framed");
    EXPECT_TRUE(world.framed);
    Scene lit = box();
    lit.ambient = glm::vec3(0.1f);
    EXPECT_THAT(resolve(lit).lights, SizeIs(0));
    EXPECT_EQ(resolve(lit).ambient, glm::vec3(0.1f));
}

TEST(Resolve, FramedCameraIsFrameOfASquarePicture) {
    for (const glm::vec3& size : {glm::vec3(1), glm::vec3(100, 1, 1), glm::vec3(0.01f, 5, 0.01f), glm::vec3(1, 0, 300)})
        for (const double away : {0.0, 10'000.0}) {
            Scene scene = box(size);
            scene.nodes[0].local = glm::translate(glm::dmat4(1), glm::dvec3(away));
            const World world = resolve(scene);
            ASSERT_THAT(world.cameras, SizeIs(1));
            const PlacedCamera &placed = world.cameras[0], expected = frame(world, 1);
            EXPECT_EQ(placed.position, expected.position);
            EXPECT_EQ(placed.axes, expected.axes);
            EXPECT_EQ(placed.camera.zfar, expected.camera.zfar);
        }
    Scene own = box();
    own.cameras.emplace_back();
    own.nodes[0].camera = 0;
    EXPECT_FALSE(resolve(own).framed);
}

TEST(IsLit, ByLightsEmittersAmbientAndEnvironment) {
    Scene scene = box();
    scene.nodes.resize(4); // 1 below 0, 2 in another tree, 3 in none
    scene.nodes[0].children = {1};
    scene.scenes.push_back({"other", {2}});
    EXPECT_FALSE(is_lit(scene));
    scene.lights.emplace_back();
    scene.emitters.emplace_back();
    EXPECT_FALSE(is_lit(scene)) << "a light that no node has";
    scene.nodes[3].light = 0;
    EXPECT_FALSE(is_lit(scene));
    scene.nodes[2].light = 0;
    EXPECT_FALSE(is_lit(scene));
    EXPECT_TRUE(is_lit(scene, 1));
    for (const bool emitter : {false, true}) {
        Scene lit = scene;
        (emitter ? lit.nodes[1].emitter : lit.nodes[1].light) = 0;
        EXPECT_TRUE(is_lit(lit));
    }
    Scene ambient = scene, surrounded = scene;
    ambient.ambient = {0, 0.1f, 0};
    EXPECT_TRUE(is_lit(ambient));
    surrounded.environment = std::make_shared<Environment>();
    EXPECT_TRUE(is_lit(surrounded));
}

TEST(Resolve, Errors) {
    const auto line = [](const Scene& scene, std::optional<uint32_t> index = {}) {
        try {
            resolve(scene, index);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    Scene scene = box();
    EXPECT_EQ(line(scene), "");
    EXPECT_THAT(line(scene, 1), HasSubstr("box: scene 1: "));
    scene.nodes[0].local[3].x = std::numeric_limits<double>::infinity();
    EXPECT_EQ(line(scene), "box: node 0: its world transform is not finite");
    scene = box(glm::vec3(3e38f));
    scene.nodes[0].local[0].x = 1e300;
    EXPECT_EQ(line(scene), "box: scene 0: a vertex's world position is not finite");
}

TEST(World, WithoutTrianglesIsEmptyAndSaysWhatThereIs) {
    const auto warning = [](const Scene& scene) {
        const World world = resolve(scene);
        EXPECT_EQ(world.triangles, 0u);
        EXPECT_EQ(world.bounds_min, glm::dvec3(0));
        EXPECT_EQ(world.bounds_max, glm::dvec3(0));
        EXPECT_GE(world.cameras.size(), 1u);
        const auto warnings = warnings_of(world);
        return warnings.empty() ? std::string() : warnings.back();
    };
    EXPECT_TRUE(warnings_of(resolve(box())).empty());
    Scene scene = box();
    scene.nodes[0].mesh.reset();
    EXPECT_EQ(warning(scene),
              fmt::format("box: scene: no triangles, so the picture is empty; the file has {} empty nodes",
                          scene.nodes.size()));
    scene.lights.resize(1);
    scene.cameras.resize(1);
    scene.nodes[0].light = 0;
    scene.nodes.resize(3);
    scene.nodes[1].light = 0;
    scene.nodes[2].camera = 0;
    scene.scenes[0].nodes = {0, 1, 2};
    EXPECT_EQ(
        warning(scene),
        "box: scene: no triangles, so the picture is empty; the file has 2 nodes with a light, 1 node with a camera");
    EXPECT_EQ(resolve(scene).lights.size(), 2u);
    scene = box();
    scene.nodes[0].visible = false;
    EXPECT_EQ(warning(scene),
              "box: scene: no triangles, so the picture is empty; the file has 1 node with a mesh that is hidden, "
              "flattened or in another scene, 1 node hidden");
    scene.nodes.clear();
    scene.scenes[0].nodes.clear();
    EXPECT_EQ(warning(scene), "box: scene: no triangles, so the picture is empty; the file has no nodes");
}

TEST(ScatterLights, AboutEightReachAPoint) {
    for (const glm::vec3& size : {glm::vec3(10, 10, 10), glm::vec3(100, 5, 80), glm::vec3(50, 0, 50)})
        for (const uint32_t count : {64u, 1'000u, 20'000u}) {
            const Scene scene = box(size);
            World world = resolve(scene);
            world.lights.clear();
            scatter_lights(world, count, 7);
            ASSERT_THAT(world.lights, SizeIs(count));
            const float range = world.lights[0].light.range;
            // Points of the inner half, on a grid: near the walls fewer lights reach.
            double reached = 0;
            constexpr int steps = 6;
            for (int i = 0; i < steps * steps * steps; ++i) {
                const glm::dvec3 t(i % steps, i / steps % steps, i / steps / steps);
                const glm::dvec3 point = glm::dvec3(size) * (0.25 + 0.5 * (t + 0.5) / double(steps));
                for (const PlacedLight& placed : world.lights)
                    reached += glm::length(placed.position - point) < double(range);
            }
            reached /= steps * steps * steps;
            EXPECT_GT(reached, 5) << size.x << ' ' << size.y << ' ' << count;
            EXPECT_LT(reached, 11) << size.x << ' ' << size.y << ' ' << count;
        }
}

TEST(ScatterLights, PropertiesAndSeed) {
    const Scene scene = box(glm::vec3(10, 20, 30));
    World world = resolve(scene), again = world, other = world;
    scatter_lights(world, 4'000, 5);
    scatter_lights(again, 4'000, 5);
    scatter_lights(other, 4'000, 6);
    ASSERT_THAT(world.lights, SizeIs(4'001)); // after the key light
    glm::dvec3 mean(0);
    size_t equal = 0;
    for (size_t i = 1; i < world.lights.size(); ++i) {
        const PlacedLight& a = world.lights[i];
        EXPECT_EQ(a.light.kind, LightKind::point);
        EXPECT_EQ(a.light.intensity, a.light.range * a.light.range / 2);
        EXPECT_EQ(std::max({a.light.colour.x, a.light.colour.y, a.light.colour.z}), 1);
        EXPECT_EQ(a.position, again.lights[i].position);
        EXPECT_EQ(a.light.colour, again.lights[i].light.colour);
        equal += a.position == other.lights[i].position;
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(a.position[k], world.bounds_min[k]);
            EXPECT_LE(a.position[k], world.bounds_max[k]);
        }
        mean += a.position / 4'000.0;
    }
    EXPECT_EQ(equal, 0u);
    expect_near(mean, {5, 10, 15}, 0.5);
}

TEST(FindCamera, ByNameOrIndex) {
    Scene scene = box();
    for (const char* name : {"left", "1", ""}) {
        scene.cameras.emplace_back().name = name;
        scene.nodes.emplace_back().camera = uint32_t(scene.cameras.size() - 1);
        scene.scenes[0].nodes.push_back(uint32_t(scene.nodes.size() - 1));
    }
    const World world = resolve(scene);
    EXPECT_EQ(&find_camera(world, "left"), &world.cameras[0]);
    EXPECT_EQ(&find_camera(world, "0"), &world.cameras[0]);
    EXPECT_EQ(&find_camera(world, "2"), &world.cameras[2]);
    EXPECT_EQ(&find_camera(world, "1"), &world.cameras[1]);
    for (const char* wrong : {"right", "3", "-1", "1x", ""}) {
        try {
            find_camera(world, wrong);
            ADD_FAILURE() << wrong;
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr("0 \"left\""));
        }
    }
}

} // namespace
