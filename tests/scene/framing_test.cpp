// frame(): how large a world shows, and from where.
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <prelight/framing.hpp>
#include <random>

namespace prelight {
namespace {

constexpr double pi = std::numbers::pi;

/// What the vertices of all triangles cover of the picture, −1 … 1 in both directions, and of the camera's axis.
struct Seen {
    glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    double width() const { return (high.x - low.x) / 2; }
    double height() const { return (high.y - low.y) / 2; }
};

/// By matrices that glm makes, where frame() solves for the camera's place.
Seen look(const World& world, const PlacedCamera& camera, double aspect) {
    const glm::dmat4 view = glm::lookAt(glm::dvec3(0), -camera.axes[2], camera.axes[1]);
    Seen seen;
    for (const Instance& instance : world.instances)
        for (const Primitive& primitive : world.mesh_of(instance).primitives)
            for (const uint32_t index : primitive.indices) {
                const glm::dvec3 at(instance.transform * glm::dvec4(glm::dvec3(primitive.positions[index]), 1));
                const glm::dvec3 p(view * glm::dvec4(at - camera.position, 1));
                const double scale = std::tan(camera.camera.yfov / 2) * -p.z;
                const glm::dvec2 place(p.x / scale / aspect, p.y / scale);
                seen.low = glm::min(seen.low, place);
                seen.high = glm::max(seen.high, place);
                seen.nearest = std::min(seen.nearest, -p.z);
                seen.farthest = std::max(seen.farthest, -p.z);
            }
    return seen;
}

void expect_framed(const World& world, double aspect, const Framing& framing) {
    const PlacedCamera camera = frame(world, aspect, framing);
    const Seen seen = look(world, camera, aspect);
    EXPECT_NEAR(std::max(seen.width(), seen.height()), framing.fit, 0.01 * framing.fit);
    const double beyond = 0.001;
    EXPECT_GE(seen.low.x, -framing.fit - beyond);
    EXPECT_GE(seen.low.y, -framing.fit - beyond);
    EXPECT_LE(seen.high.x, framing.fit + beyond);
    EXPECT_LE(seen.high.y, framing.fit + beyond);
    EXPECT_NEAR(seen.low.x + seen.high.x, 0, 0.01) << "in the middle";
    EXPECT_NEAR(seen.low.y + seen.high.y, 0, 0.01) << "in the middle";
    EXPECT_LT(camera.camera.znear, seen.nearest);
    EXPECT_GT(camera.camera.zfar, seen.farthest);
    EXPECT_GT(camera.camera.znear, 0);
    EXPECT_LT(camera.camera.zfar / camera.camera.znear, 1.0001e4 * 1.5);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(glm::dot(camera.axes[i], camera.axes[j]), i == j, 1e-12);
    const double azimuth = framing.azimuth * pi / 180, elevation = framing.elevation * pi / 180;
    const glm::dvec3 back(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                          std::cos(azimuth) * std::cos(elevation));
    EXPECT_LT(glm::length(camera.axes[2] - back), 1e-12);
}

/// Triangles through random points of a box, and one vertex far away that no triangle uses.
Scene cloud(std::mt19937& random, glm::vec3 size) {
    std::uniform_real_distribution<float> unit(-0.5f, 0.5f);
    Primitive p;
    for (int i = 0; i < 12; ++i) {
        p.positions.push_back(size * glm::vec3(unit(random), unit(random), unit(random)));
        p.indices.push_back(uint32_t(i));
    }
    p.positions.push_back(100.0f * size);
    p.normals.assign(p.positions.size(), {0, 0, 1});
    Scene scene;
    scene.name = "cloud";
    scene.materials.emplace_back();
    scene.meshes.push_back({"cloud", {p}});
    scene.scenes.emplace_back();
    return scene;
}

void add_node(Scene& scene, const glm::dmat4& local) {
    scene.scenes[0].nodes.push_back(uint32_t(scene.nodes.size()));
    scene.nodes.emplace_back().mesh = 0;
    scene.nodes.back().local = local;
}

TEST(Frame, WhatIsDrawnFillsTheShareOfThePictureThatWasAskedFor) {
    std::mt19937 random(4);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const double scale = std::pow(10, between(-4, 5));
        Scene scene =
            cloud(random, glm::vec3(float(scale * between(0.001, 1)), float(scale * between(0.001, 1)), float(scale)));
        const glm::dvec3 away =
            scale * std::pow(10, between(-1, 5)) * glm::dvec3(between(-1, 1), between(-1, 1), between(-1, 1));
        for (int node = 0; node < 1 + i % 3; ++node)
            add_node(scene, glm::rotate(glm::translate(glm::dmat4(1), away + scale * glm::dvec3(node)), between(-3, 3),
                                        glm::dvec3(between(-1, 1), between(-1, 1), 1)));
        const double elevations[] = {between(-90, 90), 90, -90, 0};
        expect_framed(resolve(scene), std::exp(between(-1.2, 1.2)),
                      {.azimuth = between(-400, 400), .elevation = elevations[i % 4], .fit = between(0.1, 0.95)});
    }
}

TEST(Frame, FlatThingsFillThePictureToo) {
    std::mt19937 random(5);
    for (const glm::vec3& size : {glm::vec3(1, 0, 2), glm::vec3(1, 2, 0), glm::vec3(0, 1, 1), glm::vec3(3, 0, 0),
                                  glm::vec3(0, 3, 0), glm::vec3(0, 0, 3)})
        for (const double elevation : {15.0, 60.0}) {
            Scene scene = cloud(random, size);
            add_node(scene, glm::dmat4(1));
            expect_framed(resolve(scene), 16.0 / 9, {.elevation = elevation});
        }
}

TEST(Frame, WithoutExtentThereIsStillACamera) {
    std::mt19937 random(6);
    for (const glm::vec3& size : {glm::vec3(0), glm::vec3(0, 2, 0)}) { // a point; a line that is looked along
        Scene scene = cloud(random, size);
        add_node(scene, glm::translate(glm::dmat4(1), glm::dvec3(5000, 1, 2)));
        const World world = resolve(scene);
        const PlacedCamera camera = frame(world, 2, {.azimuth = 0, .elevation = 90});
        const Seen seen = look(world, camera, 2);
        EXPECT_LT(seen.width(), 1e-6);
        EXPECT_LT(std::abs(seen.low.x) + std::abs(seen.low.y), 1e-6) << "in the middle";
        EXPECT_GT(seen.nearest, camera.camera.znear);
        EXPECT_LT(seen.farthest, camera.camera.zfar);
        EXPECT_LT(seen.farthest, 50);
    }
    const Scene nothing = cloud(random, glm::vec3(1)); // a world with no instance
    World empty;
    empty.scene = &nothing;
    EXPECT_TRUE(std::isfinite(frame(empty, 1).position.z));
}

TEST(Frame, TheFrontIsPlusZAndTheRightPlusX) {
    std::mt19937 random(7);
    Scene scene = cloud(random, glm::vec3(1));
    add_node(scene, glm::dmat4(1));
    const World world = resolve(scene);
    const auto from = [&](double azimuth, double elevation) {
        return frame(world, 1, {.azimuth = azimuth, .elevation = elevation});
    };
    const auto near = [](glm::dvec3 a, glm::dvec3 b) { return glm::length(a - b) < 1e-12; };
    EXPECT_TRUE(near(from(0, 0).axes[2], {0, 0, 1}));
    EXPECT_TRUE(near(from(90, 0).axes[2], {1, 0, 0}));
    EXPECT_TRUE(near(from(180, 0).axes[2], {0, 0, -1}));
    EXPECT_TRUE(near(from(0, 90).axes[2], {0, 1, 0}));
    EXPECT_TRUE(near(from(0, 90).axes[1], {0, 0, -1})) << "seen from above, the front is at the bottom";
    EXPECT_TRUE(near(from(0, -90).axes[1], {0, 0, 1})) << "seen from below, at the top";
    EXPECT_TRUE(near(from(90, 90).axes[1], {-1, 0, 0}));
    const Framing usual;
    EXPECT_GT(usual.azimuth, 0) << "a little from the right";
    EXPECT_GT(usual.elevation, 0) << "and above";
}

/// A mesh that a morph target moves is framed where it is, not where it is stored.
TEST(Frame, FollowsWhatAnimationsDeform) {
    std::mt19937 random(8);
    Scene scene = cloud(random, glm::vec3(1));
    Primitive& primitive = scene.meshes[0].primitives[0];
    MorphTarget stretch;
    for (const glm::vec3& p : primitive.positions)
        stretch.positions.push_back({0, 7 * p.y + 30, 0});
    primitive.morph_targets.push_back(stretch);
    scene.meshes[0].weights = {1};
    add_node(scene, glm::dmat4(1));
    const World world = resolve(scene);
    ASSERT_TRUE(world.instances.at(0).deformed);
    expect_framed(world, 1.5, {});
    EXPECT_GT(frame(world, 1.5).position.y, 25);
}

} // namespace
} // namespace prelight
