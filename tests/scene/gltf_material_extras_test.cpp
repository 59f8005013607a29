// extras.prelight of a material: read, written, and refused where it is wrong.
#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/material_shader.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using namespace prelight::test;
using testing::HasSubstr;

GltfBuilder material_with_own(const Json& own) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(png(1, 1, solid(1, 1, {9, 9, 9, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["extras"]["prelight"] = own;
    return b;
}

TEST(GltfMaterialExtras, ChooseAMaterialWithParametersAndTextures) {
    GltfBuilder b = material_with_own({{"material", "detailed"},
                                       {"parameters", {{"depth", 0.05}, {"detail", {2}}}},
                                       {"textures", {{"gloss_map", {{"index", 0}, {"texCoord", 1}}}}}});
    const Scene scene = b.load();
    const Material& material = scene.materials.at(0);
    ASSERT_TRUE(material.shader);
    EXPECT_EQ(material.shader->name, "detailed");
    EXPECT_EQ(material.parameters.at("depth").x, 0.05f);
    EXPECT_EQ(material.parameters.at("detail").x, 2);
    EXPECT_EQ(material.textures.at("gloss_map").texcoord, 1u);
    EXPECT_EQ(scene.meshes.at(0).primitives.at(0).tangents.size(), 3u) << "its maps may be normal maps";

    const test::TemporaryFolder folder;
    save_glb(scene, folder.path / "a.glb");
    const Material again = load_gltf(folder.path / "a.glb").materials.at(0);
    EXPECT_EQ(again.shader, material.shader);
    EXPECT_EQ(again.parameters.at("depth").x, 0.05f);
    EXPECT_EQ(again.parameters.at("detail").x, 2);
    EXPECT_EQ(again.textures.at("gloss_map").texcoord, 1u);
}

TEST(GltfMaterialExtras, ParametersOfAFileThatIsNamedElsewhereAreKept) {
    const GltfBuilder builder = material_with_own({{"parameters", {{"steps", 4}, {"ink", {0, 0.5, 1}}}}});
    const Material material = builder.load().materials.at(0);
    EXPECT_FALSE(material.shader);
    EXPECT_EQ(material.parameters.at("ink"), glm::vec4(0, 0.5f, 1, 0));
}

TEST(GltfMaterialExtras, WrongOnesAreOneLine) {
    const auto error = [](const Json& own) { return strict_error_of(material_with_own(own)); };
    EXPECT_THAT(error({{"material", "skn"}}), HasSubstr("material \"skn\" is not built in (blinn-phong"));
    EXPECT_THAT(error({{"material", "skin"}, {"parameters", {{"roll_off", -1}}}}),
                HasSubstr("roll_off of skin: -1 is outside 0 … 2"));
    EXPECT_THAT(error({{"material", "skin"}, {"parameters", {{"k", 1}}}}), HasSubstr("skin has no parameter k"));
    EXPECT_THAT(error({{"material", "skin"}, {"parameters", {{"roll_off", "much"}}}}),
                HasSubstr("parameter roll_off is neither a number"));
    EXPECT_THAT(error({{"material", "skin"}, {"parameters", {{"roll_off", {1, 2, 3, 4, 5}}}}}),
                HasSubstr("parameter roll_off is neither"));
    EXPECT_THAT(error({{"material", "skin"}, {"parameters", {1}}}), HasSubstr("parameters is not an object"));
    EXPECT_THAT(error({{"material", "detailed"}, {"textures", {{"gloss_map", {{"index", 9}}}}}}),
                HasSubstr("textures gloss_map: index"));
    EXPECT_THAT(error({{"material", "detailed"}, {"textures", {{"shine", {{"index", 0}}}}}}),
                HasSubstr("detailed has no texture shine"));
    EXPECT_THAT(error({{"material", 3}}), HasSubstr("material"));
}

TEST(GltfEnvironment, ComesThroughAFileBitForBit) {
    Scene scene = make_scene("materials", 2, 1);
    const test::TemporaryFolder folder;
    save_glb(scene, folder.path / "a.glb");
    const Scene again = load_gltf(folder.path / "a.glb");
    ASSERT_TRUE(again.environment);
    EXPECT_TRUE(again.environment->image.pixels == scene.environment->image.pixels);
    EXPECT_EQ(again.images.size(), scene.images.size());
    ASSERT_EQ(again.materials.size(), scene.materials.size());
    for (size_t m = 0; m < again.materials.size(); ++m) {
        EXPECT_EQ(again.materials[m].shader, scene.materials[m].shader);
        EXPECT_EQ(again.materials[m].parameters, scene.materials[m].parameters);
        EXPECT_EQ(again.materials[m].textures.size(), scene.materials[m].textures.size());
    }
}

TEST(GltfEnvironment, FactorTurnAndBackgroundComeThroughToo) {
    Scene scene = make_scene("materials", 2, 1);
    Environment changed = *scene.environment;
    changed.intensity = 0.3f;
    changed.rotation = -1.25;
    changed.background = false;
    scene.environment = std::make_shared<Environment>(changed);
    const test::TemporaryFolder folder;
    save_glb(scene, folder.path / "a.glb");
    const Scene again = load_gltf(folder.path / "a.glb");
    ASSERT_TRUE(again.environment);
    EXPECT_EQ(again.environment->intensity, 0.3f);
    EXPECT_EQ(again.environment->rotation, -1.25);
    EXPECT_FALSE(again.environment->background);
}

TEST(GltfEnvironment, ItsBackdropComesThroughInRgbe) {
    Scene scene = make_scene("materials", 1, 1);
    Environment changed = *scene.environment;
    changed.backdrop = soft_backdrop();
    scene.environment = std::make_shared<Environment>(changed);
    const test::TemporaryFolder folder;
    save_glb(scene, folder.path / "a.glb");
    const Scene again = load_gltf(folder.path / "a.glb");
    ASSERT_TRUE(again.environment);
    EXPECT_TRUE(again.environment->image.pixels == scene.environment->image.pixels);
    ASSERT_EQ(again.environment->backdrop.pixels.size(), changed.backdrop.pixels.size());
    for (size_t i = 0; i < changed.backdrop.pixels.size(); ++i)
        ASSERT_NEAR(again.environment->backdrop.pixels[i].g, changed.backdrop.pixels[i].g, 1.0 / 256);
}

TEST(GltfEnvironment, WithAWrongFactorIsRefused) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(png(4, 2, solid(4, 2, {9, 9, 9, 128})));
    Json& own = b.json["extras"]["prelight"]["environment"];
    own = {{"source", b.json["images"].size() - 1}, {"intensity", 2}};
    EXPECT_EQ(b.load().environment->intensity, 2);
    own["intensity"] = -1;
    EXPECT_EQ(
        expect_repaired(b, "JSON extras prelight environment: intensity is -1, outside 0 …").environment->intensity, 0);
    own["intensity"] = 1;
    own["rotation"] = "much";
    expect_repaired(b, "JSON extras prelight environment: rotation is \"much\", not a number; it is ignored");
}

TEST(GltfEnvironment, OfTheWrongShapeIsRefused) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(png(2, 2, solid(2, 2, {9, 9, 9, 128})));
    b.json["extras"]["prelight"]["environment"] = {{"source", b.json["images"].size() - 1}};
    EXPECT_FALSE(
        expect_repaired(
            b, "JSON extras prelight environment: an environment map is twice as wide as high, and this one has 2x2")
            .environment);
}

} // namespace
} // namespace prelight
