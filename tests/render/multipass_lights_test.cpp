// Hundreds of lights on one mesh, few changes of state, and what a person varies.
#include "garden.hpp"
#include "random_scene.hpp"
#include <passes/forward_plan.hpp>
#include <prelight/scene_io.hpp>
#include <prelight/vary.hpp>

namespace prelight {
namespace {

TEST(Multipass, HundredsOfLightsOnOneMesh) {
    TestWorld test;
    test.add_material({.name = "wall", .base_colour = {0.8f, 0.75f, 0.7f, 1}, .metallic = 0, .roughness = 0.5f});
    test.add(square(12));
    for (int i = 0; i < 400; ++i)
        test.add_light({.kind = LightKind::point, .intensity = 0.4f, .range = 2}, {i % 20 - 9.5, i / 20 - 9.5, 0.6});
    randomize_lights(test.world.lights, 11);
    for (const char* per_pass : {"1", "8"}) {
        Shot shot{.world = &test.world, .camera = front_camera(20), .settings = {{"lights-per-pass", per_pass}}};
        shot.renderer = "multipass";
        expect_agrees(shot);
    }
}

/// Changes of the material along a plan, over draws sorted by material, three of each.
size_t material_changes(const passes::ForwardPlan& plan) {
    size_t changes = 0;
    for (size_t i = 1; i < plan.size(); ++i)
        changes += plan[i].draw / 3 != plan[i - 1].draw / 3;
    return changes;
}

TEST(Multipass, MaterialsChangeAsLittleAsTheOrderAllows) {
    constexpr uint32_t draws = 12, lights = 10;
    resident::LightReach reach; // every light reaches every draw
    for (uint32_t d = 0; d <= draws; ++d)
        reach.first.push_back(d * lights);
    for (uint32_t i = 0; i < draws * lights; ++i)
        reach.lights.push_back(i % lights);
    const size_t materials = draws / 3;
    EXPECT_EQ(material_changes(passes::plan_base(draws)), materials - 1);
    EXPECT_EQ(material_changes(passes::plan_by_objects(reach, 1, true)), materials - 1);
    EXPECT_EQ(material_changes(passes::plan_shaded_once(reach, 8)), materials - 1);
    // A round visits each material, and the next begins where it ended.
    EXPECT_EQ(material_changes(passes::plan_by_lights(reach, 1, false)), lights * (materials - 1));
}

TEST(Vary, RotatedLightsKeepTheirDistanceAndComeBack) {
    Garden garden;
    garden.add_light(garden.spot(0.5f, 4, 3), {1, 2, 3}, {0.6, -0.8, 0});
    std::vector<PlacedLight> lights = garden.world.lights;
    rotate_lights(lights, {1, 0, 1}, 1.5707963267948966);
    // A quarter turn counter-clockwise seen from above takes +Z to +X and +X to −Z.
    EXPECT_NEAR(glm::distance(lights[0].position, {3, 2, 1}), 0, 1e-12);
    EXPECT_NEAR(glm::distance(lights[0].direction, {0, -0.8, -0.6}), 0, 1e-12);
    rotate_lights(lights, {1, 0, 1}, -1.5707963267948966);
    EXPECT_NEAR(glm::distance(lights[0].position, garden.world.lights[0].position), 0, 1e-12);
}

TEST(Vary, RandomLightsFollowTheirSeedAndStayValid) {
    Garden garden;
    garden.add_lights(200, 4, 6);
    garden.add_light({.kind = LightKind::directional}, {0, 5, 0});
    std::vector<PlacedLight> one = garden.world.lights, two = one, other = one;
    randomize_lights(one, 5);
    randomize_lights(two, 5);
    randomize_lights(other, 6);
    size_t spots = 0, different = 0;
    for (size_t i = 0; i < one.size(); ++i) {
        const Light& light = one[i].light;
        EXPECT_EQ(light.colour, two[i].light.colour);
        EXPECT_EQ(light.range, two[i].light.range);
        different += light.colour != other[i].light.colour;
        EXPECT_EQ(one[i].position, garden.world.lights[i].position);
        EXPECT_TRUE(std::isfinite(light.range) && light.range > 0);
        EXPECT_NEAR(glm::length(one[i].direction), 1, 1e-12);
        EXPECT_LE(light.inner_cone, light.outer_cone);
        spots += light.kind == LightKind::spot;
    }
    EXPECT_EQ(different, one.size());
    EXPECT_GT(spots, 60u);
    EXPECT_LT(spots, 140u);
}

TEST(Vary, MaterialsCycleThroughAllAndComeBack) {
    Scene scene = make_scene("city", 4, 1);
    std::vector<uint32_t> before;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            before.push_back(primitive.material);
    ASSERT_GT(scene.materials.size(), 2u);
    const Scene untouched = scene;
    for (size_t turn = 0; turn < scene.materials.size(); ++turn) {
        cycle_materials(scene);
        size_t i = 0;
        for (const Mesh& mesh : scene.meshes)
            for (const Primitive& primitive : mesh.primitives) {
                ASSERT_EQ(primitive.material, (before[i++] + turn + 1) % scene.materials.size());
                const TextureRef& map = scene.materials[primitive.material].normal_texture;
                if (map && !primitive.texcoords[map.texcoord].empty()) {
                    ASSERT_EQ(primitive.tangents.size(), primitive.positions.size());
                }
            }
    }
}

} // namespace
} // namespace prelight
