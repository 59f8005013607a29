// extras.prelight of a node: decals and emitters, read, written, and refused where they are wrong.
#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using namespace prelight::test;
using testing::HasSubstr;

GltfBuilder node_with_own(const Json& own) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.json["nodes"][0]["extras"]["prelight"] = own;
    return b;
}

Scene saved_and_loaded(const Scene& scene) {
    const test::TemporaryFolder folder;
    save_glb(scene, folder.path / "a.glb");
    return load_gltf(folder.path / "a.glb");
}

TEST(GltfNodeExtras, DecalsAreReadAndWritten) {
    GltfBuilder b = node_with_own({{"receivesDecals", false},
                                   {"decal",
                                    {{"material", 0},
                                     {"opacity", 0.5},
                                     {"order", -3},
                                     {"fade", {0.25, 0.75}},
                                     {"channels", {"normal", "roughness"}}}}});
    b.json["materials"][0]["extras"]["prelight"]["receivesDecals"] = false;
    const Scene first = b.load();
    for (const Scene& scene : {first, saved_and_loaded(first)}) {
        ASSERT_EQ(scene.decals.size(), 1u);
        EXPECT_EQ(scene.nodes[0].decal, 0u);
        EXPECT_FALSE(scene.nodes[0].receives_decals);
        EXPECT_FALSE(scene.materials[0].receives_decals);
        const Decal& decal = scene.decals[0];
        EXPECT_EQ(decal.material, 0u);
        EXPECT_EQ(decal.opacity, 0.5f);
        EXPECT_EQ(decal.order, -3);
        EXPECT_EQ(decal.fade_from, 0.25f);
        EXPECT_EQ(decal.fade_to, 0.75f);
        EXPECT_FALSE(decal.colour);
        EXPECT_TRUE(decal.normal && decal.roughness);
    }
    const Scene plain = node_with_own({{"decal", {{"material", 0}}}}).load();
    EXPECT_EQ(plain.decals[0].opacity, 1);
    EXPECT_TRUE(plain.decals[0].colour && plain.decals[0].normal && plain.decals[0].roughness);
    EXPECT_TRUE(plain.nodes[0].receives_decals && plain.materials[0].receives_decals);
}

TEST(GltfNodeExtras, WrongDecalsAreOneLine) {
    const auto error = [](const Json& decal) { return strict_error_of(node_with_own({{"decal", decal}})); };
    EXPECT_THAT(error(Json::object()), HasSubstr("node 0 extras prelight decal: material"));
    EXPECT_THAT(error({{"material", 7}}), HasSubstr("material is 7, but there are"));
    EXPECT_THAT(error({{"material", 0}, {"opacity", 1.5}}), HasSubstr("opacity is 1.5, outside 0 … 1"));
    EXPECT_THAT(error({{"material", 0}, {"order", 0.5}}), HasSubstr("order is not a whole number"));
    EXPECT_THAT(error({{"material", 0}, {"fade", {1, 0.5}}}), HasSubstr("fade is [1, 0.5]"));
    EXPECT_THAT(error({{"material", 0}, {"fade", {0, 2}}}), HasSubstr("fade is [0, 2]"));
    EXPECT_THAT(error({{"material", 0}, {"channels", {"color"}}}), HasSubstr("channel \"color\" is not known"));
    GltfBuilder own = node_with_own({{"decal", {{"material", 0}}}});
    own.json["materials"][0]["extras"]["prelight"]["material"] = "skin";
    EXPECT_TRUE(
        expect_repaired(own, "node 0 extras prelight decal: material 0 has a shader of its own").decals.empty());
    const Scene repaired = expect_repaired(node_with_own({{"receivesDecals", 1}}),
                                           "node 0 extras prelight: receivesDecals is 1, not true or false");
    EXPECT_TRUE(repaired.nodes[0].receives_decals);
}

TEST(GltfNodeExtras, EmittersAreReadAndWritten) {
    const Scene first = node_with_own({{"emitter",
                                        {{"count", 12},
                                         {"seed", 99},
                                         {"lifetime", {0.5, 1.5}},
                                         {"speed", {1, 2}},
                                         {"cone", 0.25},
                                         {"radius", 0.125},
                                         {"gravity", 5},
                                         {"ground", -0.5},
                                         {"bounce", 0.75},
                                         {"slip", 0.5},
                                         {"colours", {{4, 2, 1}, {1, 0, 0}}},
                                         {"intensity", 3},
                                         {"range", 2.5},
                                         {"size", 0.02},
                                         {"streak", 0.01},
                                         {"material", 0},
                                         {"castsShadow", true}}}})
                            .load();
    for (const Scene& scene : {first, saved_and_loaded(first)}) {
        ASSERT_EQ(scene.emitters.size(), 1u);
        EXPECT_EQ(scene.nodes[0].emitter, 0u);
        const Emitter& e = scene.emitters[0];
        EXPECT_EQ(e.count, 12u);
        EXPECT_EQ(e.seed, 99u);
        EXPECT_EQ(e.lifetime_from, 0.5f);
        EXPECT_EQ(e.lifetime_to, 1.5f);
        EXPECT_EQ(e.speed_to, 2);
        EXPECT_EQ(e.cone, 0.25f);
        EXPECT_EQ(e.radius, 0.125f);
        EXPECT_EQ(e.gravity, 5);
        EXPECT_EQ(e.ground, -0.5f);
        EXPECT_EQ(e.bounce, 0.75f);
        EXPECT_EQ(e.slip, 0.5f);
        ASSERT_EQ(e.colours.size(), 2u);
        EXPECT_EQ(e.colours[0], glm::vec3(4, 2, 1));
        EXPECT_EQ(e.intensity, 3);
        EXPECT_EQ(e.range, 2.5f);
        EXPECT_EQ(e.size, 0.02f);
        EXPECT_EQ(e.streak, 0.01f);
        EXPECT_TRUE(e.casts_shadow);
    }
}

TEST(GltfNodeExtras, BillboardsAreReadAndWritten) {
    const Scene first = node_with_own({{"emitter",
                                        {{"shape", "billboard"},
                                         {"lights", false},
                                         {"sizes", {0.5, 2}},
                                         {"opacities", {0, 1, 0.25}},
                                         {"spin", 1.5},
                                         {"material", 0}}}})
                            .load();
    for (const Scene& scene : {first, saved_and_loaded(first)}) {
        ASSERT_EQ(scene.emitters.size(), 1u);
        const Emitter& e = scene.emitters[0];
        EXPECT_EQ(e.shape, ParticleShape::billboard);
        EXPECT_FALSE(e.lights);
        EXPECT_EQ(e.sizes, (std::vector<float>{0.5f, 2}));
        EXPECT_EQ(e.opacities, (std::vector<float>{0, 1, 0.25f}));
        EXPECT_EQ(e.spin, 1.5f);
    }
    EXPECT_FALSE(is_lit(first)) << "particles that are no lights";
}

TEST(GltfNodeExtras, WrongEmittersAreOneLine) {
    const auto error = [](Json emitter) {
        if (!emitter.contains("material"))
            emitter["material"] = 0;
        return strict_error_of(node_with_own({{"emitter", emitter}}));
    };
    EXPECT_THAT(error({{"count", 0}}), HasSubstr("node 0 extras prelight emitter: count is 0"));
    EXPECT_THAT(error({{"count", 65537}}), HasSubstr("count is 65537, outside 1 … 65536"));
    EXPECT_THAT(error({{"lifetime", {0, 1}}}), HasSubstr("lifetime is [0, 1]"));
    EXPECT_THAT(error({{"speed", {3, 1}}}), HasSubstr("speed is [3, 1]"));
    EXPECT_THAT(error({{"cone", 4}}), HasSubstr("cone is 4"));
    EXPECT_THAT(error({{"ground", 0}, {"drag", 1}}), HasSubstr("ground goes with"));
    EXPECT_THAT(error({{"ground", 0}, {"gravity", -1}}), HasSubstr("ground goes with"));
    EXPECT_THAT(error({{"colours", Json::array()}}), HasSubstr("colours is not"));
    EXPECT_THAT(error({{"colours", {{1, 2}}}}), HasSubstr("colours is not"));
    EXPECT_THAT(error({{"colours", {{1, 2, -1}}}}), HasSubstr("colours is not"));
    EXPECT_THAT(error({{"range", 0}}), HasSubstr("range is 0"));
    EXPECT_THAT(error({{"material", 5}}), HasSubstr("material is 5"));
    EXPECT_THAT(error({{"shape", "cube"}}), HasSubstr("shape \"cube\" is not known (octahedron, billboard)"));
    EXPECT_THAT(error({{"sizes", Json::array()}}), HasSubstr("sizes is not an array of 1 to 64 numbers"));
    EXPECT_THAT(error({{"opacities", {0.5, 1.5}}}), HasSubstr("opacities is not an array"));
    EXPECT_THAT(error({{"sizes", {1, "x"}}}), HasSubstr("sizes is not an array"));
    EXPECT_THAT(error({{"sizes", 3}}), HasSubstr("sizes is not an array"));
    EXPECT_THAT(error({{"opacities", {{"0", 1}}}}), HasSubstr("opacities is not an array"));
    EXPECT_THAT(error({{"sizes", std::vector<int>(65, 1)}}), HasSubstr("sizes is not an array of 1 to 64 numbers"));
    EXPECT_THAT(error({{"spin", -1}}), HasSubstr("spin is -1"));
    EXPECT_EQ(node_with_own({{"emitter", {{"size", 0}}}}).load().emitters.size(), 1u)
        << "without shapes no material is needed";
}

TEST(GltfNodeExtras, ManyParticlesOfASmallFileAreRefused) {
    GltfBuilder b = node_with_own({{"emitter", {{"count", 65536}, {"material", 0}}}});
    for (int i = 0; i < 15; ++i)
        b.json["nodes"].push_back(b.json["nodes"][0]);
    EXPECT_THAT(error_of(b), HasSubstr("emitter: "));
}

} // namespace
} // namespace prelight
