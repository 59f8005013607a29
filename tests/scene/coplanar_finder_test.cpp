#include "coplanar.hpp"

#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace prelight {
namespace {

/// A square of 1 m, `corner` its lower left one, facing +z, in a primitive of its own.
Primitive square(glm::vec3 corner, glm::vec4 colour = glm::vec4(1)) {
    Primitive p;
    for (const glm::vec2& at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        p.positions.push_back(corner + glm::vec3(at, 0));
        p.normals.emplace_back(0, 0, 1);
        p.colours.push_back(colour);
    }
    p.indices = {0, 1, 2, 0, 2, 3};
    return p;
}

/// One mesh of squares; `second` moves another node with the last of them only.
Scene squares(std::vector<Primitive> list, std::optional<glm::dmat4> second = {}) {
    Scene scene;
    scene.materials.resize(1);
    scene.nodes.resize(1);
    scene.scenes = {{.name = {}, .nodes = {0}}};
    scene.meshes.resize(2);
    if (second) {
        scene.meshes[1].primitives.push_back(list.back());
        list.pop_back();
        scene.nodes.push_back({.local = *second});
        scene.nodes[1].mesh = 1;
        scene.scenes[0].nodes.push_back(1);
    }
    scene.meshes[0].primitives = std::move(list);
    scene.nodes[0].mesh = 0;
    return scene;
}

double area(const Scene& scene) {
    const World world = resolve(scene);
    double sum = 0;
    for (const CoplanarPair& pair : find_coplanar(world))
        sum += pair.area;
    return sum;
}

TEST(Coplanar, FindsTheSharedAreaOfTwoPrimitives) {
    EXPECT_NEAR(area(squares({square({0, 0, 0}), square({0.75f, 0.5f, 0})})), 0.125, 1e-6);
    EXPECT_NEAR(area(squares({square({0, 0, 0}), square({0.75f, 0.5f, 9e-4f})})), 0.125, 1e-6);
    EXPECT_NEAR(area(squares({square({0, 0, 0}), square({0.75f, 0.5f, -9e-4f})})), 0.125, 1e-6);
}

TEST(Coplanar, LeavesApartWhatIsApart) {
    EXPECT_EQ(area(squares({square({0, 0, 0}), square({0, 0, 1.1e-3f})})), 0);
    EXPECT_EQ(area(squares({square({0, 0, 0}), square({1, 0, 0})})), 0) << "neighbours";
    EXPECT_EQ(area(squares({square({0, 0, 0}), square({2, 0, 0})})), 0);
    EXPECT_EQ(area(squares({square({0, 0, 0}), square({0.995f, 0.995f, 0})})), 0) << "too small";
}

TEST(Coplanar, FindsTwoInstancesInWorldSpace) {
    const glm::dmat4 beside = glm::translate(glm::dmat4(1), {10, 0, 0});
    EXPECT_NEAR(area(squares({square({0, 0, 0}), square({-10, 0, 0})}, beside)), 1, 1e-6);
    EXPECT_EQ(area(squares({square({0, 0, 0}), square({0, 0, 0})}, beside)), 0);
}

TEST(Coplanar, CountsOnlyTheNearPartOfATiltedPlane) {
    // About a vertical axis: 1 mm is reached after 1 mm ÷ sin 0.4° = 0.1432 m.
    const auto turned = [](double degrees) {
        return glm::rotate(glm::dmat4(1), degrees * std::numbers::pi / 180, {0, 1, 0});
    };
    EXPECT_NEAR(area(squares({square({0, 0, 0}), square({0, 0, 0})}, turned(0.4))), 0.1432, 1e-3);
    EXPECT_EQ(area(squares({square({0, 0, 0}), square({0, 0, 0})}, turned(0.6))), 0);
}

TEST(Coplanar, OppositeFacesCountOnlyWhenDoubleSided) {
    const glm::dmat4 about = glm::rotate(glm::dmat4(1), std::numbers::pi, {0, 1, 0});
    Scene scene = squares({square({0, 0, 0}), square({-1, 0, 0})}, about);
    EXPECT_EQ(area(scene), 0);
    scene.materials[0].double_sided = true;
    EXPECT_NEAR(area(scene), 1, 1e-6);
}

TEST(Coplanar, AMirroredInstanceFacesAsItIsDrawn) {
    const glm::dmat4 mirrored = glm::scale(glm::dmat4(1), {-1, 1, 1});
    EXPECT_NEAR(area(squares({square({0, 0, 0}), square({-1, 0, 0})}, mirrored)), 1, 1e-6);
}

TEST(Coplanar, OnePrimitiveCountsWhenItsColoursDiffer) {
    for (const bool differ : {false, true}) {
        Primitive both = square({0, 0, 0});
        const Primitive other = square({0, 0, 0}, glm::vec4(differ ? 0.5f : 1.0f));
        for (size_t i = 0; i < 4; ++i) {
            both.positions.push_back(other.positions[i]);
            both.normals.push_back(other.normals[i]);
            both.colours.push_back(other.colours[i]);
        }
        for (const uint32_t i : other.indices)
            both.indices.push_back(i + 4);
        EXPECT_NEAR(area(squares({both})), differ ? 1 : 0, 1e-6);
    }
}

} // namespace
} // namespace prelight
