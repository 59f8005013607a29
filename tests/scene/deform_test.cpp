// Morph targets and skins against computation by hand.
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/scene.hpp>
#include <scene/deform.hpp>
#include <scene/near.hpp>
#include <scene/tangents.hpp>

using namespace prelight;
using prelight::test::expect_near;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

/// A strip of two triangles in z = 0 facing +z, x in 0 … 1, y in 0 … 1, with tangents along x.
Primitive strip() {
    Primitive p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    p.normals.assign(4, {0, 0, 1});
    p.tangents.assign(4, {1, 0, 0, 1});
    p.indices = {0, 1, 2, 0, 2, 3};
    return p;
}

Scene scene_of(Primitive p) {
    Scene scene;
    scene.name = "test";
    scene.materials.emplace_back();
    scene.meshes.push_back({"mesh", {std::move(p)}});
    scene.nodes.emplace_back().mesh = 0;
    scene.scenes.push_back({"", {0}});
    return scene;
}

/// World position of a vertex.
glm::dvec3 place(const World& world, uint32_t vertex, size_t instance = 0) {
    const Instance& shown = world.instances.at(instance);
    return glm::dvec3(shown.transform * glm::dvec4(world.mesh_of(shown).primitives.at(0).positions.at(vertex), 1));
}

glm::dvec3 previous_place(const World& world, uint32_t vertex) {
    const Instance& shown = world.instances.at(0);
    const Primitive& p = world.mesh_of(shown).primitives.at(0);
    const auto& places = p.previous_positions.empty() ? p.positions : p.previous_positions;
    return glm::dvec3(shown.previous_transform.value_or(shown.transform) * glm::dvec4(places.at(vertex), 1));
}

Scene morphing() {
    Primitive p = strip();
    p.morph_targets.resize(2);
    p.morph_targets[0].positions = {{0, 0, 0}, {0, 0, 4}, {0, 0, 4}, {0, 0, 0}};
    p.morph_targets[0].normals.assign(4, {-1, 0, 0});
    p.morph_targets[1].positions.assign(4, {0, -2, 0});
    p.morph_targets[1].tangents.assign(4, {0, 1, 0});
    return scene_of(std::move(p));
}

TEST(Morph, AddsWeightedTargets) {
    Scene scene = morphing();
    EXPECT_FALSE(resolve(scene).instances[0].deformed) << "all weights are zero";
    scene.meshes[0].weights = {0.25f, 0.5f};
    const World world = resolve(scene);
    ASSERT_TRUE(world.instances[0].deformed);
    expect_near(place(world, 1), {1, -1, 1});
    expect_near(place(world, 3), {0, 0, 0});
    const Primitive& p = world.deformed[0].primitives[0];
    expect_near(p.normals[0], glm::normalize(glm::dvec3(-0.25, 0, 1)));
    expect_near(p.tangents[0], glm::normalize(glm::dvec3(1, 0.5, 0)));
    EXPECT_EQ(p.tangents[0].w, 1);
    EXPECT_THAT(p.morph_targets, SizeIs(0));
    EXPECT_EQ(world.bounds_max, glm::dvec3(1, 0, 1)) << "bounds are of the deformed mesh";
    EXPECT_TRUE(p.previous_positions.empty());

    scene.nodes[0].weights = {0, 1}; // the node's come before the mesh's
    expect_near(place(resolve(scene), 1), {1, -2, 0});
}

TEST(Morph, AnimatedWeightsMoveVertices) {
    Scene scene = morphing();
    scene.animations.push_back({"", {{{0, 1}, {0, 0, 1, 1}, Interpolation::linear}}, {{0, 0, AnimationPath::weights}}});
    scene.nodes[0].local = glm::translate(glm::dmat4(1), {0, 0, -3}); // weights need no TRS
    const World world = resolve(scene, {}, Moment{0.5, 0.25});
    expect_near(place(world, 1), {1, -1, -1});
    expect_near(previous_place(world, 1), {1, -0.5, -2});
    EXPECT_FALSE(world.instances[0].previous_transform);
    // Just before the start nothing moves: as the mesh is stored, and still what changes in place at the next moment.
    const World before = resolve(scene, {}, Moment{0, 0.25});
    ASSERT_TRUE(before.instances[0].deformed);
    EXPECT_EQ(before.deformed[0].primitives[0].positions, scene.meshes[0].primitives[0].positions);
    EXPECT_THAT(before.deformed[0].primitives[0].previous_positions, SizeIs(0));
    // At rest now, but it was bent before.
    scene.animations[0].samplers[0].values = {1, 1, 0, 0};
    const World later = resolve(scene, {}, Moment{1, 0.5});
    expect_near(place(later, 1), {1, 0, -3});
    expect_near(previous_place(later, 1), {1, -1, -1});
}

TEST(Morph, NodesWithEqualWeightsShareTheirShape) {
    Scene scene = morphing();
    scene.nodes.resize(3);
    scene.scenes[0].nodes = {0, 1, 2};
    for (uint32_t i = 0; i < 3; ++i) {
        scene.nodes[i].mesh = 0;
        scene.nodes[i].weights = {i == 2 ? 0.5f : 0.25f, 0};
    }
    const World world = resolve(scene);
    EXPECT_THAT(world.deformed, SizeIs(2));
    EXPECT_EQ(world.instances[0].deformed, world.instances[1].deformed);
    EXPECT_NE(world.instances[0].deformed, world.instances[2].deformed);
}

/// The strip follows joint 0 (node 1) at x = 0 and joint 1 (node 2, child of 1) at x = 1; the corner
/// (1, 1) half and half.
Scene skinned_strip() {
    Primitive p = strip();
    p.joint_sets.resize(1);
    p.joint_sets[0].joints = {{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}};
    p.joint_sets[0].weights = {{1, 0, 0, 0}, {1, 0, 0, 0}, {0.5f, 0.5f, 0, 0}, {0.25f, 0.5f, 0.25f, 0}};
    Scene scene = scene_of(std::move(p));
    scene.nodes.resize(3);
    scene.scenes[0].nodes = {0, 1};
    scene.nodes[0].skin = 0;
    scene.nodes[0].local = glm::translate(glm::dmat4(1), {100, 100, 100}); // to be ignored
    scene.nodes[1].children = {2};
    scene.nodes[1].trs = Trs{};
    scene.nodes[2].trs = Trs{{1, 0, 0}};
    scene.nodes[2].local = scene.nodes[2].trs->matrix();
    scene.skins.push_back({"skin", {1, 2}, {glm::dmat4(1), glm::translate(glm::dmat4(1), {-1, 0, 0})}});
    return scene;
}

TEST(Skin, AtItsBindPoseIsTheMeshItself) {
    const Scene scene = skinned_strip();
    const World world = resolve(scene);
    for (uint32_t v = 0; v < 4; ++v)
        expect_near(place(world, v), scene.meshes[0].primitives[0].positions[v]);
    EXPECT_EQ(world.bounds_max, glm::dvec3(1, 1, 0));
    EXPECT_EQ(world.triangles, 2u);
}

TEST(Skin, FollowsItsJointsAndNotItsNode) {
    Scene scene = skinned_strip();
    const float s = std::sqrt(0.5f);
    // Joint 1 turns by 90° about z in one second; the whole skeleton is lifted by 10 m.
    scene.nodes[1].local = glm::translate(glm::dmat4(1), {0, 0, 10});
    scene.animations.push_back(
        {"bend", {{{0, 1}, {0, 0, 0, 1, 0, 0, s, s}, Interpolation::linear}}, {{0, 2, AnimationPath::rotation}}});
    const World world = resolve(scene, {}, Moment{1, 0.5});
    expect_near(place(world, 0), {0, 0, 10});
    expect_near(place(world, 1), {1, 0, 10});
    // Joint 0 keeps (1, 1), joint 1 turns it about (1, 0) to (0, 0).
    expect_near(place(world, 2), {0.5, 0.5, 10});
    expect_near(place(world, 3), {0, 1, 10});
    // Half a second before: (1, 1) by 45° about (1, 0) is (1 − √½, √½).
    const double h = std::sqrt(0.5);
    expect_near(previous_place(world, 2), {1 - 0.5 * h, 0.5 + 0.5 * h, 10});
    expect_near(previous_place(world, 0), {0, 0, 10});
    const Primitive& p = world.mesh_of(world.instances[0]).primitives[0];
    expect_near(p.tangents[1], {0, 1, 0});
    expect_near(p.normals[1], {0, 0, 1});
    EXPECT_TRUE(p.joint_sets.empty());
}

TEST(Skin, ComesAfterMorphTargets) {
    Scene scene = skinned_strip();
    scene.meshes[0].primitives[0].morph_targets.resize(1);
    scene.meshes[0].primitives[0].morph_targets[0].positions.assign(4, {0, 1, 0});
    scene.meshes[0].weights = {1};
    scene.nodes[2].local = glm::rotate(scene.nodes[2].local, std::acos(-1.0), {0, 0, 1});
    const World world = resolve(scene);
    expect_near(place(world, 0), {0, 1, 0});
    expect_near(place(world, 1), {1, -1, 0});
}

TEST(Skin, KeepsMillimetresFarFromTheOrigin) {
    Scene scene = skinned_strip();
    // Weights whose floats do not sum up to 1.
    scene.meshes[0].primitives[0].joint_sets[0].weights[0] = {0.1f, 0.7f, 0.1f, 0.1f};
    scene.nodes[1].local = glm::translate(glm::dmat4(1), {10'000.001, -20'000.002, 30'000.003});
    const World world = resolve(scene);
    expect_near(place(world, 0), {10'000.001, -20'000.002, 30'000.003}, 1e-6);
    expect_near(place(world, 2), {10'001.001, -19'999.002, 30'000.003}, 1e-6);
}

TEST(Skin, UnevenScaleTiltsNormalsByTheInverseTranspose) {
    Scene scene = skinned_strip();
    Primitive& p = scene.meshes[0].primitives[0];
    p.normals.assign(4, glm::normalize(glm::vec3(1, 0, 1)));
    p.tangents.assign(4, glm::vec4(glm::normalize(glm::vec3(1, 0, -1)), -1));
    scene.nodes[1].local = glm::scale(glm::dmat4(1), {4, 1, 1});
    const World world = resolve(scene);
    const Primitive& bent = world.mesh_of(world.instances[0]).primitives[0];
    expect_near(bent.normals[0], glm::normalize(glm::dvec3(0.25, 0, 1)));
    expect_near(bent.tangents[0], glm::normalize(glm::dvec3(4, 0, -1)));
    EXPECT_EQ(bent.tangents[0].w, -1);
}

TEST(Skin, MirroringJointsKeepFrontsAtTheFront) {
    Scene scene = skinned_strip();
    scene.nodes[1].local = glm::scale(glm::dmat4(1), {-1, 1, 1});
    const World world = resolve(scene);
    EXPECT_FALSE(world.instances[0].mirrored);
    const Primitive& p = world.mesh_of(world.instances[0]).primitives[0];
    expect_near(p.normals[0], {0, 0, 1});
    expect_near(p.tangents[0], {-1, 0, 0});
    EXPECT_EQ(p.tangents[0].w, -1) << "the bitangent still points up: w · (N × T) = +y";
    const glm::dvec3 a = place(world, p.indices[0]);
    const glm::dvec3 face = glm::cross(place(world, p.indices[1]) - a, place(world, p.indices[2]) - a);
    EXPECT_GT(face.z, 0) << "wound counter-clockwise seen from the normal's side";
}

TEST(Skin, FlatNormalsAreMadeAnew) {
    Scene scene = skinned_strip();
    Primitive& p = scene.meshes[0].primitives[0];
    p.normals.clear();
    make_flat_normals(p);
    ASSERT_THAT(p.joint_sets[0].joints, SizeIs(6));
    scene.nodes[2].local = glm::rotate(scene.nodes[2].local, 0.8, {0, 1, 0});
    const World world = resolve(scene);
    const Primitive& bent = world.mesh_of(world.instances[0]).primitives[0];
    for (size_t i = 0; i < 6; i += 3) {
        const glm::dvec3 a(bent.positions[i]);
        const glm::dvec3 face =
            glm::normalize(glm::cross(glm::dvec3(bent.positions[i + 1]) - a, glm::dvec3(bent.positions[i + 2]) - a));
        for (size_t c = 0; c < 3; ++c)
            expect_near(bent.normals[i + c], face);
    }
}

TEST(Skin, WhatDoesNotFitEndsInALine) {
    const auto line = [](auto damage) -> std::string {
        Scene scene = skinned_strip();
        damage(scene);
        try {
            resolve(scene);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(line([](Scene&) {}), "");
    EXPECT_THAT(line([](Scene& s) { s.meshes[0].primitives[0].joint_sets[0].joints[1][0] = 2; }),
                HasSubstr("test: node 0: vertex 1 follows joint 2, but its skin has 2"));
    EXPECT_THAT(line([](Scene& s) { s.nodes[0].skin = 1; }), HasSubstr("test: skin 1: is not there"));
    EXPECT_THAT(line([](Scene& s) { s.skins[0].joints = {}; }), HasSubstr("skin 0: has no joints"));
    EXPECT_THAT(line([](Scene& s) { s.skins[0].joints[1] = 9; }), HasSubstr("skin 0: joint 1 is not there"));
    EXPECT_THAT(line([](Scene& s) { s.skins[0].inverse_bind.pop_back(); }), HasSubstr("fewer inverse bind"));
    EXPECT_THAT(line([](Scene& s) { s.skins[0].inverse_bind[0][0][0] = 1e308 * 10; }),
                HasSubstr("skin 0: the matrix of joint 0 is not finite"));
    EXPECT_THAT(line([](Scene& s) { s.skins[0].inverse_bind[0][0][0] = 1e300; }), HasSubstr("node 0: its vertex"));
    // Without joints in the mesh the skin has nothing to move: the mesh stays at its node.
    Scene scene = skinned_strip();
    scene.meshes[0].primitives[0].joint_sets.clear();
    expect_near(place(resolve(scene), 0), {100, 100, 100});
}

TEST(Deform, IsBounded) {
    Scene scene = morphing();
    Primitive& p = scene.meshes[0].primitives[0];
    p.positions.resize(1'000'000);
    p.normals.resize(1'000'000, {0, 0, 1});
    p.tangents.clear();
    p.morph_targets.resize(1);
    p.morph_targets[0] = {};
    scene.nodes.resize(20);
    scene.scenes[0].nodes.clear();
    for (uint32_t i = 0; i < 20; ++i) {
        scene.nodes[i].mesh = 0;
        scene.nodes[i].weights = {float(i + 1)};
        scene.scenes[0].nodes.push_back(i);
    }
    try {
        resolve(scene);
        FAIL() << "20 million vertices were deformed";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("test: node 8: the scene's skins and morph targets move more"));
    }
}

TEST(World, IsCopiedAndMovedWithItsDeformedMeshes) {
    const Scene scene = skinned_strip();
    World first = resolve(scene);
    const glm::dvec3 before = place(first, 2);
    const World copy = first;
    const World moved = std::move(first);
    EXPECT_EQ(place(copy, 2), before);
    EXPECT_EQ(place(moved, 2), before);
    EXPECT_NE(&copy.mesh_of(copy.instances[0]), &moved.mesh_of(moved.instances[0]));
}

} // namespace
