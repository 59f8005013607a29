#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <reference/light_tree.hpp>

namespace prelight::reference {
namespace {

/// Lights of very different ranges, some unbounded, some in the same place.
World many_lights(uint32_t count) {
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    World world;
    for (uint32_t i = 0; i < count; ++i) {
        Light light{.kind = i % 3 ? LightKind::point : LightKind::spot};
        light.range = static_cast<float>(i % 50 == 0 ? uniform(20, 60) : uniform(0.1, 4));
        if (i % 701 == 0)
            light.range = std::numeric_limits<float>::infinity();
        if (i % 997 == 0)
            light.kind = LightKind::directional;
        glm::dvec3 position(uniform(-50, 50), uniform(0, 5), uniform(-50, 50));
        if (i % 10 == 0)
            position = {1, 2, 3};
        world.lights.push_back({light, position, {0, -1, 0}});
    }
    return world;
}

TEST(LightTree, FindsExactlyTheLightsThatReach) {
    const World world = many_lights(5000);
    const glm::dvec3 origin(5, 6, 7);
    const LightTree tree(world, origin);
    std::mt19937 random(8);
    std::vector<uint32_t> found;
    size_t total = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 point(static_cast<double>(random() % 1000) / 10 - 50, static_cast<double>(random() % 60) / 10,
                               static_cast<double>(random() % 1000) / 10 - 50);
        std::vector<uint32_t> want;
        for (uint32_t l = 0; l < world.lights.size(); ++l) {
            const PlacedLight& placed = world.lights[l];
            if (placed.light.kind == LightKind::directional || std::isinf(placed.light.range) ||
                glm::distance(placed.position, point) < double(placed.light.range))
                want.push_back(l);
        }
        tree.reach(point - origin, found);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, want) << "point " << i;
        total += want.size();
    }
    EXPECT_GT(total, 3000u);
}

TEST(LightTree, NoLightsAndOneLight) {
    World world;
    std::vector<uint32_t> found{1, 2, 3};
    LightTree(world, {0, 0, 0}).reach({0, 0, 0}, found);
    EXPECT_TRUE(found.empty());
    world.lights.push_back({Light{.range = 2}, {1, 0, 0}, {0, 0, -1}});
    LightTree(world, {0, 0, 0}).reach({0, 0, 0}, found);
    EXPECT_EQ(found, std::vector<uint32_t>{0});
    LightTree(world, {0, 0, 0}).reach({-1.5, 0, 0}, found);
    EXPECT_TRUE(found.empty());
}

} // namespace
} // namespace prelight::reference
