#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <prelight/error.hpp>
#include <prelight/scene_building.hpp>

namespace prelight {
namespace {

Primitive square_of(bool indexed) {
    Primitive square{.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
    if (indexed)
        square.indices = {0, 1, 2, 0, 2, 3};
    else
        square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    return square;
}

TEST(BuiltScene, ShowsWhatWasAdded) {
    Scene scene;
    const uint32_t white = add_material(scene, {.name = "white"});
    const glm::dmat4 right(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1);
    const uint32_t first = add_object(scene, "square", square_of(true), white);
    const uint32_t second = add_object(scene, "triangle", square_of(false), white, right);
    const World world = resolve(scene);
    ASSERT_EQ(world.instances.size(), 2u);
    EXPECT_EQ(world.triangles, 3u);
    EXPECT_EQ(world.instances[0].node, first);
    EXPECT_EQ(world.instances[1].node, second);
    EXPECT_EQ(world.bounds_max, glm::dvec3(6, 1, 0));
    const Primitive& made = scene.meshes[0].primitives[0];
    EXPECT_EQ(made.positions.size(), 6u) << "each corner its own";
    EXPECT_THAT(made.normals, testing::Each(glm::vec3(0, 0, 1)));
    EXPECT_TRUE(made.tangents.empty());
    EXPECT_THAT(scene.meshes[1].primitives[0].indices, testing::ElementsAre(0, 1, 2));
}

TEST(BuiltScene, MakesTangentsForNormalMaps) {
    Scene scene;
    const uint32_t image = add_image(scene, {"bumps", 1, 1, {128, 128, 255, 255}});
    Material mapped;
    mapped.normal_texture.image = image;
    const uint32_t material = add_material(scene, mapped);
    Primitive square = square_of(true);
    EXPECT_THROW(add_object(scene, "square", square, material), Error) << "no texture coordinates";
    EXPECT_TRUE(scene.nodes.empty() && scene.meshes.empty() && scene.scenes.empty());
    square.texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    add_object(scene, "square", square, material);
    const Primitive& made = scene.meshes[0].primitives[0];
    ASSERT_EQ(made.tangents.size(), made.positions.size());
    for (const glm::vec4& tangent : made.tangents)
        EXPECT_NEAR(tangent.x, 1, 1e-6f);
}

TEST(BuiltScene, SquaresThatFaceTheCamera) {
    Scene scene;
    const uint32_t image = add_image(scene, {"bumps", 1, 1, {128, 128, 255, 255}});
    Material smoke{.alpha_mode = AlphaMode::blend, .softness = 0.5f};
    smoke.normal_texture.image = image;
    const uint32_t material = add_material(scene, smoke);
    Primitive puff{.positions = {4, glm::vec3(1, 2, 3)}, .indices = {0, 1, 2, 0, 2, 3}};
    puff.texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    puff.facing = {{-3, -4}, {3, -4}, {3, 4}};
    EXPECT_THROW(add_object(scene, "puff", puff, material), Error) << "three offsets";
    puff.facing.emplace_back(-3, 4);
    add_object(scene, "puff", puff, material);
    const Primitive& made = scene.meshes[0].primitives[0];
    EXPECT_THAT(made.normals,
                testing::ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)));
    EXPECT_THAT(made.tangents, testing::Each(glm::vec4(1, 0, 0, 1)));
    const World world = resolve(scene);
    EXPECT_EQ(world.bounds_min, glm::dvec3(-4, -3, -2)) << "whoever looks";
    EXPECT_EQ(world.bounds_max, glm::dvec3(6, 7, 8));
    smoke.softness = -1;
    EXPECT_THROW(add_material(scene, smoke), Error);
}

TEST(BuiltScene, RefusesWhatCannotBeDrawn) {
    Scene scene;
    scene.name = "mine";
    add_material(scene, {});
    const auto refusal = [&](const std::function<void(Primitive&)>& spoil, const char* reason, uint32_t material = 0,
                             glm::dmat4 transform = glm::dmat4(1)) {
        Primitive square = square_of(true);
        spoil(square);
        EXPECT_THAT([&] { add_object(scene, "square", square, material, transform); },
                    testing::ThrowsMessage<Error>(testing::StrEq(std::string("mine: object square: ") + reason)));
    };
    const auto as_it_is = [](Primitive&) {};
    refusal(
        [](Primitive& p) {
            p.positions.clear();
            p.indices.clear();
        },
        "no positions");
    refusal([](Primitive& p) { p.indices.pop_back(); }, "5 indices are no whole triangles");
    refusal([](Primitive& p) { p.indices[4] = 4; }, "index 4 of 4 positions");
    refusal([](Primitive& p) { p.normals.resize(3, {0, 0, 1}); }, "3 normals for 4 positions");
    refusal([](Primitive& p) { p.normals.resize(4, {0, 0, 2}); }, "a normal that is not of unit length");
    refusal([](Primitive& p) { p.positions[1].x = std::numeric_limits<float>::infinity(); },
            "positions: a number that is not finite");
    refusal(as_it_is, "material 1 of 1", 1);
    refusal(as_it_is, "its transform is none of objects (finite, last row 0 0 0 1)", 0, glm::dmat4(2));
    EXPECT_TRUE(scene.nodes.empty());
    EXPECT_THAT(
        [&] {
            add_image(scene, {"small", 2, 2, {1, 2, 3, 4}});
        },
        testing::ThrowsMessage<Error>("mine: image small: 4 bytes for 2x2 pixels of 4"));
    Material textured{.name = "textured"};
    textured.base_colour_texture.image = 3;
    EXPECT_THAT([&] { add_material(scene, textured); },
                testing::ThrowsMessage<Error>("mine: material textured: the base colour: image 3 of 0"));
}

} // namespace
} // namespace prelight
