// KHR_materials_pbrSpecularGlossiness: plain metallic-roughness where that says the same, else a material of its own.
#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/material_shader.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using namespace prelight::test;

GltfBuilder with_extension(const Json& extension, Json material = Json::object()) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(png(1, 1, solid(1, 1, {128, 64, 32, 200})));
    b.add_image(png(1, 1, solid(1, 1, {200, 100, 50, 128})));
    b.json["textures"] = Json::array({{{"source", 0}}, {{"source", 1}}});
    material["extensions"]["KHR_materials_pbrSpecularGlossiness"] = extension;
    b.json["materials"][0] = material;
    b.json["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness"};
    b.json["extensionsRequired"] = {"KHR_materials_pbrSpecularGlossiness"};
    return b;
}

Material read(const Json& extension, const Json& material = Json::object()) {
    const Scene scene = with_extension(extension, material).load();
    EXPECT_TRUE(scene.warnings.empty());
    return scene.materials.at(0);
}

TEST(GltfSpecularGlossiness, OfADielectricIsMetallicRoughness) {
    const Material m = read({{"diffuseFactor", {0.8, 0.1, 0.1, 0.5}},
                             {"specularFactor", {0.04, 0.04, 0.04}},
                             {"glossinessFactor", 0.25},
                             {"diffuseTexture", {{"index", 0}}}});
    EXPECT_FALSE(m.shader);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(m.base_colour[c], (c == 0 ? 0.8 : 0.1) * 0.96, 1e-6) << "diffuse (1 − F0)";
    EXPECT_EQ(m.base_colour.a, 0.5f);
    EXPECT_EQ(m.metallic, 0);
    EXPECT_EQ(m.roughness, 0.75f);
    EXPECT_TRUE(m.base_colour_texture);
}

TEST(GltfSpecularGlossiness, OfAMetalIsMetallicRoughness) {
    const Material m = read({{"diffuseFactor", {0, 0, 0, 1}},
                             {"specularFactor", {1, 0.75, 0.25}},
                             {"glossinessFactor", 1},
                             {"diffuseTexture", {{"index", 0}}}});
    EXPECT_FALSE(m.shader);
    EXPECT_EQ(m.base_colour, glm::vec4(1, 0.75f, 0.25f, 1));
    EXPECT_EQ(m.metallic, 1);
    EXPECT_EQ(m.roughness, 0);
    EXPECT_FALSE(m.base_colour_texture) << "black times anything";
}

TEST(GltfSpecularGlossiness, OfAnythingElseHasAMaterialOfItsOwn) {
    const GltfBuilder b = with_extension(
        {{"diffuseFactor", {0.5, 0.25, 0.125, 1}},
         {"specularFactor", {0.5, 0.25, 0.75}},
         {"glossinessFactor", 0.5},
         {"diffuseTexture", {{"index", 0}}},
         {"specularGlossinessTexture", {{"index", 1}}}},
        {{"pbrMetallicRoughness", {{"metallicFactor", 0.3}, {"baseColorFactor", {1, 0, 0, 1}}}}, {"name", "both"}});
    const TemporaryFolder folder;
    const Scene first = b.load();
    save_glb(first, folder.path / "a.glb");
    for (const Scene& scene : {first, load_gltf(folder.path / "a.glb")}) {
        const Material& m = scene.materials.at(0);
        ASSERT_TRUE(m.shader);
        EXPECT_EQ(m.shader->name, "specular-glossiness");
        EXPECT_EQ(m.base_colour, glm::vec4(0.5f, 0.25f, 0.125f, 1)) << "the extension's, not the fallback's";
        EXPECT_EQ(m.parameters.at("specular"), glm::vec4(0.5f, 0.25f, 0.75f, 0));
        EXPECT_EQ(m.parameters.at("glossiness").x, 0.5f);
        const auto red = [&](const TextureRef& ref) { return scene.images.at(ref.image).rgba.at(0); };
        EXPECT_EQ(red(m.base_colour_texture), 128);
        EXPECT_EQ(red(m.textures.at("specular_glossiness_map")), 200);
    }
    const Material all = read(Json::object());
    ASSERT_TRUE(all.shader);
    EXPECT_EQ(all.parameters.at("specular"), glm::vec4(1, 1, 1, 0)) << "the defaults are a white mirror";
    EXPECT_EQ(all.parameters.at("glossiness").x, 1);
}

TEST(GltfSpecularGlossiness, WithoutLightKeepsItsDiffuseColour) {
    const Material m = read({{"diffuseFactor", {0.5, 0.25, 0.125, 1}}, {"specularFactor", {0.5, 0.25, 0.75}}},
                            {{"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    EXPECT_FALSE(m.shader);
    EXPECT_TRUE(m.unlit);
    EXPECT_EQ(m.base_colour, glm::vec4(0.5f, 0.25f, 0.125f, 1));
}

TEST(GltfSpecularGlossiness, OutOfRangeIsTakenForTheNearest) {
    const Scene scene = expect_repaired(
        with_extension({{"specularFactor", {2, 0.5, -1}}}),
        "material 0 KHR_materials_pbrSpecularGlossiness: specularFactor is 2, outside 0 … 1; 1 is used");
    EXPECT_EQ(scene.materials[0].parameters.at("specular"), glm::vec4(1, 0.5f, 0, 0));
    EXPECT_EQ(
        expect_repaired(with_extension({{"glossinessFactor", "high"}}),
                        "material 0 KHR_materials_pbrSpecularGlossiness: glossinessFactor is \"high\", not a number")
            .materials[0]
            .roughness,
        0);
}

} // namespace
} // namespace prelight
