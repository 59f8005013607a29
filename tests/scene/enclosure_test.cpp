#include <gtest/gtest.h>
#include <prelight/scene.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

/// Floor and walls of a box from −half to half, seen from inside
/// or from outside.
Scene box_scene(glm::vec3 half, bool inwards) {
    Primitive walls;
    const auto quad = [&](glm::vec3 centre, glm::vec3 u, glm::vec3 v) {
        const auto first = static_cast<uint32_t>(walls.positions.size());
        for (const glm::vec3& p : {centre - u - v, centre + u - v, centre + u + v, centre - u + v}) {
            walls.positions.push_back(p);
            walls.normals.push_back(glm::normalize(glm::cross(u, v)));
        }
        for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
            walls.indices.push_back(first + i);
    };
    const float sign = inwards ? -1.0f : 1.0f;
    quad({half.x, 0, 0}, {0, 0, sign * -half.z}, {0, half.y, 0});
    quad({-half.x, 0, 0}, {0, 0, sign * half.z}, {0, half.y, 0});
    quad({0, 0, half.z}, {sign * half.x, 0, 0}, {0, half.y, 0});
    quad({0, 0, -half.z}, {sign * -half.x, 0, 0}, {0, half.y, 0});
    quad({0, -half.y, 0}, {half.x, 0, 0}, {0, 0, sign * half.z});
    Scene scene;
    scene.name = "box";
    scene.materials.push_back({});
    scene.scenes.push_back({});
    add_root(scene, "box", glm::dmat4(1)).mesh = add_mesh(scene, "box", walls, 0);
    return scene;
}

TEST(Enclosure, ACourtyardIsSeenFromInside) {
    const Scene courtyard = box_scene({9, 4, 5}, true), block = box_scene({9, 4, 5}, false);
    EXPECT_EQ(resolve(block).cameras.at(0).camera.name, "framed");
    const PlacedCamera inside = resolve(courtyard).cameras.at(0);
    EXPECT_EQ(inside.camera.name, "inside");
    EXPECT_LT(inside.position.x, 0);
    EXPECT_GT(inside.position.x, -9);
    EXPECT_NEAR(inside.position.y, -4 + 1.7, 1e-6);
    EXPECT_LT(inside.axes[2].x, -0.9) << "looks along the longer side";
}

TEST(Enclosure, ASmallBoxIsAnObject) {
    for (const bool inwards : {false, true}) {
        const Scene scene = box_scene({1, 1, 1}, inwards);
        EXPECT_EQ(resolve(scene).cameras.at(0).camera.name, "framed");
    }
}

} // namespace
} // namespace prelight
