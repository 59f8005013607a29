// The built-in scene `glass`: what it holds, and where sorting its objects by the middle of their bounds cannot be
// right.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

struct Glass : testing::Test {
    const Scene scene = make_scene("glass", 16, 1);
    const World world = resolve(scene);
    const PlacedCamera& front = find_camera(world, "front");

    std::vector<const Instance*> named(const char* name) const {
        std::vector<const Instance*> found;
        for (const Instance& instance : world.instances)
            if (scene.nodes[instance.node].name == name)
                found.push_back(&instance);
        return found;
    }
    static glm::dvec3 middle(const Instance& instance) { return instance.transform[3]; }
    /// Of a rectangle that make_ground() made.
    static glm::dvec3 normal(const Instance& instance) { return instance.transform[1]; }
    /// Of the middle of an object's bounds, along the view.
    double depth(const Instance& instance) const {
        glm::dvec3 low(1e9), high(-1e9);
        for (const glm::vec3& position : world.mesh_of(instance).primitives.at(0).positions) {
            const glm::dvec3 at = instance.transform * glm::dvec4(position, 1);
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        return glm::dot(front.position - 0.5 * (low + high), front.axes[2]);
    }
};

TEST_F(Glass, IsBlendedAndBothSidesOfSheetsShow) {
    size_t blended = 0, textured = 0, glowing = 0;
    for (const Material& material : scene.materials) {
        glowing += material.alpha_mode == AlphaMode::opaque && material.emissive != glm::vec3(0);
        if (material.alpha_mode != AlphaMode::blend)
            continue;
        ++blended;
        textured += bool(material.base_colour_texture);
        EXPECT_TRUE(material.double_sided) << material.name;
        EXPECT_GT(material.base_colour.a, 0) << material.name;
        EXPECT_LT(material.base_colour.a, 1) << material.name;
    }
    EXPECT_GE(blended, 15u);
    EXPECT_EQ(textured, 3u); // smoke
    EXPECT_GE(glowing, 6u);
    EXPECT_LT(world.triangles, 60000u);
}

TEST_F(Glass, PanesCross) {
    const std::vector<const Instance*> panes = named("crossing pane");
    ASSERT_EQ(panes.size(), 3u);
    for (const Instance* a : panes)
        for (const Instance* b : panes)
            if (a != b) { // the middle of one lies in the other, and they are turned against each other
                EXPECT_LT(std::abs(glm::dot(middle(*a) - middle(*b), normal(*b))), 1e-9);
                EXPECT_LT(glm::distance(middle(*a), middle(*b)), 1e-9);
                EXPECT_LT(std::abs(glm::dot(normal(*a), normal(*b))), 0.9);
            }
}

TEST_F(Glass, TheLongPaneHasADepthThatIsWrongForBothItsBottles) {
    const std::vector<const Instance*> panes = named("long pane"), bottles = named("bottle beside the long pane");
    ASSERT_EQ(panes.size(), 1u);
    ASSERT_EQ(bottles.size(), 2u);
    size_t before = 0;
    for (const Instance* bottle : bottles) {
        // How far along the ray through the bottle the pane is, in units of the bottle's distance.
        const glm::dvec3 from = front.position, ray = middle(*bottle) - from, out = normal(*panes[0]);
        const double pane = glm::dot(middle(*panes[0]) - from, out) / glm::dot(ray, out);
        EXPECT_GT(std::abs(pane - 1), 0.01);
        EXPECT_NE(pane > 1, depth(*panes[0]) > depth(*bottle));
        before += pane > 1;
    }
    EXPECT_EQ(before, 1u);
}

TEST_F(Glass, PuffsOfSmokeStandOneBehindAnother) {
    std::vector<double> depths;
    for (const Instance* puff : named("smoke")) {
        EXPECT_GT(std::abs(glm::dot(glm::normalize(normal(*puff)), front.axes[2])), 1 - 1e-9);
        depths.push_back(depth(*puff));
    }
    EXPECT_GE(depths.size(), 10u);
    std::sort(depths.begin(), depths.end());
    for (size_t i = 1; i < depths.size(); ++i)
        EXPECT_GT(depths[i] - depths[i - 1], 0.005);
}

TEST_F(Glass, LightsOfItsOwnComeFirst) {
    const Scene many = make_scene("glass", 200, 1);
    ASSERT_EQ(many.lights.size(), 200u);
    for (size_t i = 0; i < 10; ++i)
        EXPECT_FALSE(many.lights[i].name.empty());
    for (size_t i = 10; i < many.lights.size(); ++i)
        EXPECT_TRUE(many.lights[i].name.empty());
}

} // namespace
} // namespace prelight
