// What the device learns of where things were at the moment's previous state.
#include "devices.hpp"
#include <glm/ext/matrix_transform.hpp>
#include <resident/gpu_scene.hpp>
#include <resident/objects.hpp>
#include <resident/projection.hpp>

namespace prelight {
namespace {

class Motion : public OnDevice {};

glm::vec3 divided(glm::vec4 clip) { return glm::vec3(clip) / clip.w; }

void expect_near(glm::vec3 a, glm::vec3 b, float tolerance) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(MotionConstants, PreviousClipSpaceIsThatOfThePreviousCamera) {
    for (const ProjectionKind kind : {ProjectionKind::perspective, ProjectionKind::orthographic}) {
        Camera camera;
        camera.kind = kind;
        camera.zfar = 50;
        camera.ymag = 3;
        const glm::dvec3 far_off(10'000, 0, -7'000);
        PlacedCamera now = look_at(camera, far_off + glm::dvec3(1, 2, 8), far_off);
        const PlacedCamera before =
            look_at(camera, far_off + glm::dvec3(0.5, 1.5, 8.25), far_off + glm::dvec3(0.1, 0, 0));
        shared::FrameConstants still{}, moved{}, expected{};
        resident::fill_camera(still, now, 320, 180);
        EXPECT_EQ(still.previous_clip_from_world, still.clip_from_world);
        resident::fill_camera(expected, before, 320, 180);
        now.previous = CameraPose{before.position, before.axes};
        resident::fill_camera(moved, now, 320, 180);
        EXPECT_EQ(moved.clip_from_world, still.clip_from_world);
        for (const glm::dvec3& offset : {glm::dvec3(0), glm::dvec3(0.7, -0.3, 0.2), glm::dvec3(-2, 1, -5)}) {
            const glm::dvec3 point = far_off + offset;
            const glm::vec4 seen = moved.previous_clip_from_world * glm::vec4(glm::vec3(point - now.position), 1);
            const glm::vec4 right = expected.clip_from_world * glm::vec4(glm::vec3(point - before.position), 1);
            expect_near(divided(seen), divided(right), 1e-6f);
        }
    }
}

TEST(MotionConstants, PreviousRowsAreRelativeToTheCurrentCamera) {
    const glm::dvec3 camera(10'000, 20, -3);
    Instance instance;
    instance.transform = glm::translate(glm::dmat4(1), {10'001, 20, -5});
    const shared::ObjectData still = resident::object_data(instance, resident::normal_rows(instance), camera);
    for (int row = 0; row < 3; ++row)
        EXPECT_EQ(still.previous_world_row[row], still.world_row[row]);
    instance.previous_transform = glm::rotate(glm::translate(glm::dmat4(1), {10'000.5, 20, -5}), 1.0, {0, 0, 1});
    const shared::ObjectData moved = resident::object_data(instance, resident::normal_rows(instance), camera);
    const glm::dvec3 point(0.25, 0.5, 2);
    const glm::dvec3 expected = glm::dvec3(*instance.previous_transform * glm::dvec4(point, 1)) - camera;
    for (int row = 0; row < 3; ++row) {
        EXPECT_EQ(moved.world_row[row], still.world_row[row]);
        EXPECT_NEAR(glm::dot(moved.previous_world_row[row], glm::vec4(glm::vec3(point), 1)), expected[row], 1e-6);
    }
}

Primitive triangle() {
    Primitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    primitive.normals.assign(3, {0, 0, 1});
    primitive.indices = {0, 1, 2};
    return primitive;
}

TEST_F(Motion, PreviousVerticesAreThereOnlyWhenAskedForAndMoved) {
    Scene scene;
    scene.name = "test";
    scene.materials.emplace_back();
    scene.meshes = {{"still", {triangle()}}, {"unused", {triangle(), triangle()}}, {"bent", {triangle()}}};
    World world;
    world.scene = &scene;
    world.deformed = {{"bent", {triangle()}}};
    world.deformed[0].primitives[0].positions[0].x = -4;
    world.instances.resize(2);
    world.instances[1].mesh = 2;
    world.instances[1].deformed = 0;

    const resident::Geometry still = resident::upload_geometry(context(), world, {.motion = true}, {}, {});
    EXPECT_EQ(still.positions.size(), 6 * sizeof(glm::vec3)) << "what no instance shows is not there";
    EXPECT_EQ(still.previous(), still.positions.handle());
    ASSERT_EQ(still.draws.size(), 2u);
    EXPECT_EQ(still.draws[1].vertex_offset, 3);
    EXPECT_EQ(still.draws[1].low.x, -4) << "the box is that of the deformed mesh";

    world.deformed[0].primitives[0].previous_positions = {{7, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const resident::Geometry unasked = resident::upload_geometry(context(), world, {}, {}, {});
    EXPECT_EQ(unasked.previous(), unasked.positions.handle());
    const resident::Geometry moved = resident::upload_geometry(context(), world, {.motion = true}, {}, {});
    EXPECT_NE(moved.previous(), moved.positions.handle());
    EXPECT_EQ(moved.previous_positions.size(), 6 * sizeof(glm::vec3));
    std::swap(world.instances[0], world.instances[1]); // what moves comes first
    EXPECT_EQ(resident::upload_geometry(context(), world, {.motion = true}, {}, {}).previous_positions.size(),
              6 * sizeof(glm::vec3));
}

} // namespace
} // namespace prelight
