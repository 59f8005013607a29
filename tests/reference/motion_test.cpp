// Where the reference says that surfaces were one interval before.
#include "worlds.hpp"
#include <gtest/gtest.h>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

ReferencePicture picture_of(const World& world, const PlacedCamera& camera) {
    return render_reference(world, camera, 64, 36, 0, {});
}

TEST(ReferenceMotion, WhatStandsStillWasThere) {
    TestWorld test;
    test.add(square(10));
    const ReferencePicture picture = picture_of(test.world, front_camera(3));
    for (size_t i = 0; i < picture.position.size(); ++i)
        ASSERT_EQ(picture.previous_position[i], picture.position[i]);
}

TEST(ReferenceMotion, ObjectsAndVerticesMove) {
    TestWorld test;
    test.add(square(10), glm::translate(glm::dmat4(1), {10'000, 0, 0}));
    PlacedCamera camera = front_camera(3);
    camera.position.x = 10'000;
    // A quarter turn about the object's own z, half a metre lower.
    test.world.instances[0].previous_transform =
        glm::rotate(glm::translate(glm::dmat4(1), {10'000, -0.5, 0}), -1.5707963267948966, {0, 0, 1});
    ReferencePicture picture = picture_of(test.world, camera);
    for (size_t i = 0; i < picture.position.size(); ++i) {
        const glm::dvec3 p = picture.position[i] - glm::dvec3(10'000, 0, 0);
        ASSERT_LT(glm::distance(picture.previous_position[i], glm::dvec3(10'000 + p.y, -p.x - 0.5, p.z)), 1e-9);
    }
    // The square was half as large in its own space.
    test.world.instances[0].previous_transform.reset();
    test.world.deformed = {test.scene.meshes[0]};
    test.world.instances[0].deformed = 0;
    Primitive& p = test.world.deformed[0].primitives[0];
    for (const glm::vec3& position : p.positions)
        p.previous_positions.push_back(0.5f * position);
    picture = picture_of(test.world, camera);
    for (size_t i = 0; i < picture.position.size(); ++i) {
        const glm::dvec3 now = picture.position[i] - glm::dvec3(10'000, 0, 0);
        ASSERT_LT(glm::distance(picture.previous_position[i], glm::dvec3(10'000, 0, 0) + 0.5 * now), 1e-9);
    }
}

// All of the scene `motion`: what a world says of its previous state is what the world of that time is.
TEST(ReferenceMotion, PreviousStateIsTheEarlierWorld) {
    const Scene scene = make_scene("motion", 8, 1);
    for (const double time : {0.4, 1.7, 3.1}) {
        const Moment moment{time, 0.05};
        const World now = resolve(scene, {}, moment), before = resolve(scene, {}, Moment{time - 0.05, 0});
        ASSERT_EQ(now.instances.size(), before.instances.size());
        size_t moved_objects = 0, moved_meshes = 0;
        for (size_t i = 0; i < now.instances.size(); ++i) {
            const Instance &a = now.instances[i], &b = before.instances[i];
            const Mesh &mesh = now.mesh_of(a), &earlier = before.mesh_of(b);
            moved_objects += a.previous_transform.has_value();
            for (size_t p = 0; p < mesh.primitives.size(); ++p) {
                const Primitive& primitive = mesh.primitives[p];
                moved_meshes += !primitive.previous_positions.empty();
                const auto& places =
                    primitive.previous_positions.empty() ? primitive.positions : primitive.previous_positions;
                for (size_t v = 0; v < places.size(); ++v) {
                    const glm::dvec4 told = a.previous_transform.value_or(a.transform) * glm::dvec4(places[v], 1);
                    const glm::dvec4 was = b.transform * glm::dvec4(earlier.primitives[p].positions[v], 1);
                    ASSERT_LT(glm::distance(told, was), 2e-6) << "instance " << i << " vertex " << v;
                }
            }
        }
        EXPECT_GE(moved_objects, 14u) << "six boxes, eight balls";
        EXPECT_EQ(moved_meshes, 2u) << "the column and the blob";
        const PlacedCamera& flight = find_camera(now, "flight");
        ASSERT_TRUE(flight.previous);
        EXPECT_EQ(flight.previous->position, find_camera(before, "flight").position);
        EXPECT_FALSE(find_camera(now, "front").previous);
        EXPECT_NE(now.lights[0].position, before.lights[0].position);
        // And the picture follows: no pixel's surface was where it is, but for the stage and the hand.
        const ReferencePicture picture = picture_of(now, flight);
        size_t moved = 0;
        for (size_t i = 0; i < picture.position.size(); ++i)
            moved += picture.previous_position[i] != picture.position[i];
        EXPECT_GT(moved, 150u);
        EXPECT_LT(moved, picture.position.size() / 2);
    }
}

} // namespace
} // namespace prelight
