// Which surfaces inferred lighting tells apart, and which layers share its texels.
#include "random_scene.hpp"
#include <resident/layer_slots.hpp>
#include <resident/projection.hpp>
#include <resident/smooth_groups.hpp>
#include <set>

namespace prelight {
namespace {

size_t groups_in(const Primitive& primitive) {
    const std::vector<uint32_t> groups = resident::smooth_groups(primitive);
    EXPECT_EQ(groups.size(), primitive.positions.size());
    for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3)
        for (size_t k = 1; k < 3; ++k)
            EXPECT_EQ(groups[primitive.indices[i]], groups[primitive.indices[i + k]]);
    return std::set<uint32_t>(groups.begin(), groups.end()).size();
}

TEST(SmoothGroups, ABoxHasSixAndABallOne) {
    EXPECT_EQ(groups_in(cube()), 6u);
    EXPECT_EQ(groups_in(sphere(16)), 1u);
    EXPECT_EQ(groups_in(square(1)), 1u);
}

TEST(SmoothGroups, TrianglesThatShareNoVertexAreJoinedByPlaceAndNormal) {
    const Primitive whole = sphere(16);
    Primitive soup;
    for (const uint32_t index : whole.indices) {
        soup.indices.push_back(static_cast<uint32_t>(soup.positions.size()));
        soup.positions.push_back(whole.positions[index]);
        soup.normals.push_back(whole.normals[index]);
    }
    EXPECT_EQ(groups_in(soup), 1u);
    for (glm::vec3& normal : soup.normals) // as flat as can be
        normal = glm::vec3(static_cast<float>((&normal - soup.normals.data()) / 3), 0, 0);
    EXPECT_EQ(groups_in(soup), soup.indices.size() / 3);
}

/// Blended cubes of half a metre, each its own object, seen from z = 5.
struct Cubes {
    World world;
    resident::Geometry geometry;

    explicit Cubes(const std::vector<glm::dvec3>& places) {
        for (const glm::dvec3& place : places) {
            const auto number = static_cast<uint32_t>(world.instances.size());
            world.instances.push_back({.transform = glm::translate(glm::dmat4(1), place)});
            resident::Draw draw;
            draw.object = number;
            draw.features = FEATURE_BLENDED;
            draw.own_low = glm::vec3(-0.25f);
            draw.own_high = glm::vec3(0.25f);
            geometry.draws.push_back(draw);
            geometry.draws_of.push_back({number});
        }
    }
    resident::LayerSlots slots() const {
        const PlacedCamera camera = front_camera(5);
        shared::FrameConstants constants{};
        resident::fill_camera(constants, camera, 160, 90);
        resident::LayerSlots out;
        resident::find_layer_slots(out, geometry, world, constants, camera.position, {160, 90});
        return out;
    }
};

using testing::ElementsAre;

TEST(LayerSlots, ApartEachHasItsOwn) {
    const resident::LayerSlots slots = Cubes({{-3, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {3, 0, 0}}).slots();
    EXPECT_THAT(slots.of, ElementsAre(1, 2, 3, 1));
    EXPECT_EQ(slots.drawn, 4u);
    EXPECT_EQ(slots.without_own, 0u);
}

TEST(LayerSlots, WhereTheyMeetTheNextThatIsFreeIsTaken) {
    // The fourth would have the first's slot, and meets it and the third.
    const resident::LayerSlots slots = Cubes({{0, 0, 0}, {-3, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}).slots();
    EXPECT_THAT(slots.of, ElementsAre(1, 2, 3, 2));
    EXPECT_EQ(slots.without_own, 0u);
}

TEST(LayerSlots, DoNotChangeWhenObjectsPassEachOtherInDepth) {
    const auto of = [](double a, double b, double c) {
        return Cubes({{0, 0, a}, {0.1, 0, b}, {0, 0.1, c}}).slots().of;
    };
    EXPECT_EQ(of(-1, 0, 1), of(1, 0, -1));
    EXPECT_EQ(of(-1, 0, 1), of(0, 1, -1));
}

TEST(LayerSlots, FourThatMeetShareThree) {
    const resident::LayerSlots slots = Cubes({{0, 0, 0}, {0.1, 0, 1}, {0, 0.1, -1}, {0.1, 0.1, 0.5}}).slots();
    EXPECT_THAT(slots.of, ElementsAre(1, 2, 3, 1));
    EXPECT_EQ(slots.without_own, 1u);
}

TEST(LayerSlots, WhatIsHiddenOrElsewhereHasNoneAndKeepsItsNumber) {
    Cubes cubes({{0, 0, 0}, {0.1, 0, 0}, {40, 0, 0}, {0, 0, 5}});
    cubes.geometry.draws[0].visible = false;
    // The third is beside the picture; the fourth is around the camera, and so all over it.
    EXPECT_THAT(cubes.slots().of, ElementsAre(0, 2, 0, 1));
}

} // namespace
} // namespace prelight
