// KHR_materials_ior, _specular, _clearcoat, _sheen, _transmission and _volume become parameters of the material
// `layered`.
#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/material_shader.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using namespace prelight::test;
using testing::HasSubstr;

GltfBuilder with_extensions(const Json& extensions) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(png(1, 1, solid(1, 1, {9, 9, 9, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["extensions"] = extensions;
    return b;
}

TEST(GltfMaterialLayers, AreReadWithTheirTextures) {
    const Material m =
        with_extensions(
            {{"KHR_materials_ior", {{"ior", 1.33}}},
             {"KHR_materials_specular",
              {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 2}}, {"specularTexture", {{"index", 0}}}}},
             {"KHR_materials_clearcoat",
              {{"clearcoatFactor", 0.75},
               {"clearcoatRoughnessFactor", 0.25},
               {"clearcoatRoughnessTexture", {{"index", 0}}}}},
             {"KHR_materials_sheen", {{"sheenColorFactor", {0.1, 0.2, 0.3}}, {"sheenRoughnessFactor", 0.5}}}})
            .load()
            .materials.at(0);
    ASSERT_TRUE(m.shader);
    EXPECT_EQ(m.shader->name, "layered");
    EXPECT_EQ(m.parameters.at("ior").x, 1.33f);
    EXPECT_EQ(m.parameters.at("specular").x, 0.5f);
    EXPECT_EQ(m.parameters.at("specular_colour"), glm::vec4(1, 0.5f, 2, 0));
    EXPECT_EQ(m.parameters.at("clearcoat").x, 0.75f);
    EXPECT_EQ(m.parameters.at("clearcoat_roughness").x, 0.25f);
    EXPECT_EQ(m.parameters.at("sheen_colour"), glm::vec4(0.1f, 0.2f, 0.3f, 0));
    EXPECT_EQ(m.parameters.at("sheen_roughness").x, 0.5f);
    EXPECT_TRUE(m.textures.at("specular_map"));
    EXPECT_TRUE(m.textures.at("clearcoat_roughness_map"));
}

TEST(GltfMaterialLayers, ThatSayNothingNewLeaveTheMaterialAsItWas) {
    for (const Json& extensions :
         {Json{{"KHR_materials_ior", {{"ior", 1.5}}}}, Json{{"KHR_materials_specular", Json::object()}},
          Json{{"KHR_materials_clearcoat", {{"clearcoatFactor", 0}, {"clearcoatRoughnessFactor", 0.5}}}},
          Json{{"KHR_materials_sheen", Json::object()}},
          Json{{"KHR_materials_ior", {{"ior", 2}}}, {"KHR_materials_unlit", Json::object()}}})
        EXPECT_FALSE(with_extensions(extensions).load().materials.at(0).shader) << extensions;
}

TEST(GltfMaterialLayers, OutOfTheirRangesAreTakenForTheNearest) {
    EXPECT_THAT(strict_error_of(with_extensions({{"KHR_materials_ior", {{"ior", 0.5}}}})),
                HasSubstr("ior 0.5 is outside 1 … 1000"));
    EXPECT_THAT(strict_error_of(with_extensions({{"KHR_materials_clearcoat", {{"clearcoatFactor", 2}}}})),
                HasSubstr("clearcoat 2 is outside 0 … 1"));
    EXPECT_THAT(strict_error_of(with_extensions({{"KHR_materials_sheen", {{"sheenColorFactor", {0, -1, 0}}}}})),
                HasSubstr("sheen_colour -1 is outside"));
    EXPECT_EQ(with_extensions({{"KHR_materials_ior", {{"ior", 0.5}}}}).load().materials.at(0).parameters.at("ior").x,
              1);
    EXPECT_THAT(error_of(with_extensions({{"KHR_materials_specular", {{"specularTexture", {{"index", 4}}}}}})),
                HasSubstr("specularTexture"));
    EXPECT_EQ(with_extensions({{"KHR_materials_ior", {{"ior", 0}}}}).load().materials.at(0).parameters.at("ior").x,
              1000)
        << "glTF's word for a mirror";
}

Json transmission(const Json& volume = Json::object()) {
    return {{"KHR_materials_transmission", {{"transmissionFactor", 0.75}, {"transmissionTexture", {{"index", 0}}}}},
            {"KHR_materials_volume", volume}};
}

TEST(GltfTransmission, IsReadWithItsVolume) {
    const Material m = with_extensions(transmission({{"thicknessFactor", 0.5},
                                                     {"thicknessTexture", {{"index", 0}, {"texCoord", 1}}},
                                                     {"attenuationDistance", 2},
                                                     {"attenuationColor", {0.1, 0.5, 0.9}}}))
                           .load()
                           .materials.at(0);
    ASSERT_TRUE(m.shader);
    EXPECT_EQ(m.shader->name, "layered");
    EXPECT_TRUE(transmits(m));
    EXPECT_EQ(m.parameters.at("transmission").x, 0.75f);
    EXPECT_EQ(m.parameters.at("thickness").x, 0.5f);
    EXPECT_EQ(m.parameters.at("attenuation_distance").x, 2);
    EXPECT_EQ(m.parameters.at("attenuation_colour"), glm::vec4(0.1f, 0.5f, 0.9f, 0));
    EXPECT_TRUE(m.textures.at("transmission_map"));
    EXPECT_EQ(m.textures.at("thickness_map").texcoord, 1u);
    EXPECT_FALSE(material_fault(m));
}

TEST(GltfTransmission, IsWrittenAndReadBack) {
    const Scene first = with_extensions(transmission({{"thicknessFactor", 0.5},
                                                      {"thicknessTexture", {{"index", 0}}},
                                                      {"attenuationDistance", 2},
                                                      {"attenuationColor", {0.1, 0.5, 0.9}}}))
                            .load();
    const TemporaryFolder folder;
    save_glb(first, folder.path / "a.glb");
    const Material m = load_gltf(folder.path / "a.glb").materials.at(0);
    EXPECT_TRUE(transmits(m));
    EXPECT_EQ(m.parameters.at("attenuation_colour"), first.materials.at(0).parameters.at("attenuation_colour"));
    for (const char* number : {"transmission", "thickness", "attenuation_distance"})
        EXPECT_EQ(m.parameters.at(number).x, first.materials.at(0).parameters.at(number).x) << number;
    EXPECT_TRUE(m.textures.at("transmission_map"));
    EXPECT_TRUE(m.textures.at("thickness_map"));
}

TEST(GltfTransmission, ThatLetsNothingThroughIsNone) {
    for (const Json& extensions :
         {Json{{"KHR_materials_transmission", Json::object()}},
          Json{{"KHR_materials_transmission", {{"transmissionFactor", 0}, {"transmissionTexture", {{"index", 0}}}}}},
          Json{{"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationColor", {1, 0, 0}}}}},
          Json{{"KHR_materials_transmission", {{"transmissionFactor", 1}}}, {"KHR_materials_unlit", Json::object()}}}) {
        const Material m = with_extensions(extensions).load().materials.at(0);
        EXPECT_FALSE(m.shader) << extensions;
        EXPECT_FALSE(transmits(m)) << extensions;
    }
    EXPECT_FALSE(with_extensions(transmission()).load().materials.at(0).parameters.contains("thickness"));
}

TEST(GltfTransmission, ValuesOutOfRangeAreRepaired) {
    EXPECT_THAT(strict_error_of(with_extensions({{"KHR_materials_transmission", {{"transmissionFactor", 1.5}}}})),
                HasSubstr("material 0 KHR_materials_transmission: transmission 1.5 is outside 0 … 1; 1 is used"));
    EXPECT_THAT(strict_error_of(with_extensions(transmission({{"thicknessFactor", -1}}))),
                HasSubstr("material 0 KHR_materials_volume: thickness -1 is outside 0 …"));
    EXPECT_THAT(strict_error_of(with_extensions(transmission({{"attenuationColor", {0, 2, 0}}}))),
                HasSubstr("attenuation_colour 2 is outside 0 … 1"));
    const GltfBuilder none = with_extensions(transmission({{"attenuationDistance", 0}, {"thicknessFactor", 1}}));
    EXPECT_THAT(strict_error_of(none),
                HasSubstr("KHR_materials_volume: attenuationDistance 0 is not above 0; nothing is absorbed"));
    EXPECT_FALSE(none.load().materials.at(0).parameters.contains("attenuation_distance"));
    EXPECT_THAT(strict_error_of(with_extensions(transmission({{"thicknessFactor", "thick"}}))),
                HasSubstr("thicknessFactor"));
    EXPECT_THAT(error_of(with_extensions(transmission({{"thicknessTexture", {{"index", 4}}}}))),
                HasSubstr("thicknessTexture"));
}

} // namespace
} // namespace prelight
