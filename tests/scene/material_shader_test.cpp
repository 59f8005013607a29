// What the declarations in a material's file mean, and what is wrong with some.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <prelight/scene.hpp>

namespace prelight {
namespace {

using testing::HasSubstr;

const std::string code = "Surface surface(Point p) { return gltf_surface(p); }\n"
                         "vec3 shade(Point p, Surface s, Light light) { return s.base; }\n";

std::string message(const std::string& source) {
    try {
        parse_material_shader("a.glsl", "folder/a.glsl", source);
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing";
}

TEST(MaterialShader, DeclaresParametersAndTextures) {
    const auto shader = parse_material_shader("a", "a", R"(// A material
// of two lines.
#include "shared/relief.glsl"
PARAMETERS {
    float width DEFAULT(0.5) RANGE(0.0, 1.0); // how wide
    // a remark
    vec3 colour DEFAULT(vec3(0.1, 0.2, 0.3)) RANGE(0.0, 2.0);
    float after DEFAULT(-1.0) RANGE(-1.0, 1e3);
    vec2 pair DEFAULT(vec2(4)) RANGE(0, 4);
};
TEXTURE_LINEAR(2) width_map DEFAULT(flat); // of the width
TEXTURE_COLOUR(0) tint DEFAULT(required);
)" + code);
    EXPECT_EQ(shader->description, "A material of two lines.");
    ASSERT_EQ(shader->parameters.size(), 4u);
    const MaterialParameter& width = shader->parameters[0];
    EXPECT_EQ(width.name, "width");
    EXPECT_EQ(width.default_value.x, 0.5f);
    EXPECT_EQ(width.description, "how wide");
    EXPECT_EQ(shader->find_parameter("colour")->default_value, glm::vec4(0.1f, 0.2f, 0.3f, 0));
    EXPECT_EQ(shader->find_parameter("pair")->default_value, glm::vec4(4, 4, 0, 0));
    EXPECT_EQ(shader->find_parameter("after")->low, -1);
    EXPECT_EQ(shader->find_parameter("after")->high, 1000);
    // std140
    EXPECT_EQ(shader->find_parameter("colour")->offset, 16u);
    EXPECT_EQ(shader->find_parameter("after")->offset, 28u);
    EXPECT_EQ(shader->find_parameter("pair")->offset, 32u);
    EXPECT_EQ(shader->parameter_bytes, 40u);
    ASSERT_EQ(shader->textures.size(), 2u);
    EXPECT_EQ(shader->textures[0].slot, 2u);
    EXPECT_EQ(shader->textures[0].stand_in, MaterialTexture::StandIn::flat);
    EXPECT_TRUE(shader->textures[1].colour);
    EXPECT_EQ(shader->find_texture("tint")->stand_in, MaterialTexture::StandIn::required);
    EXPECT_EQ(shader->find_parameter("height"), nullptr);
}

TEST(MaterialShader, MistakesNameFileAndLine) {
    const auto block = [](const char* line) { return "PARAMETERS {\n" + std::string(line) + "\n};\n" + code; };
    EXPECT_THAT(message(block("int n DEFAULT(1) RANGE(0, 2);")), HasSubstr("folder/a.glsl:2: a parameter reads"));
    EXPECT_THAT(message(block("float n RANGE(0, 2);")), HasSubstr("a.glsl:2: a parameter reads"));
    EXPECT_THAT(message(block("vec3 n DEFAULT(1) RANGE(0, 2);")), HasSubstr("a.glsl:2: a parameter reads"));
    EXPECT_THAT(message(block("float n DEFAULT(3) RANGE(0, 2);")), HasSubstr("default 3 is outside 0 … 2"));
    EXPECT_THAT(message(block("float n DEFAULT(1) RANGE(0, 2);\nfloat n DEFAULT(1) RANGE(0, 2);")),
                HasSubstr("a.glsl:3: parameter n is there twice"));
    EXPECT_THAT(message("PARAMETERS {\n};\n" + code), HasSubstr("without a parameter"));
    EXPECT_THAT(message("PARAMETERS {\nfloat n DEFAULT(1) RANGE(0, 2);\n"), HasSubstr("has no end"));
    EXPECT_THAT(message("TEXTURE_LINEAR(8) a DEFAULT(white);\n" + code),
                HasSubstr("a.glsl:1: texture a: slots are 0 … 7"));
    EXPECT_THAT(message("TEXTURE_LINEAR(0) a DEFAULT(pink);\n" + code), HasSubstr("white, black, flat or required"));
    EXPECT_THAT(message("TEXTURE_LINEAR(0) a DEFAULT(white);\nTEXTURE_LINEAR(0) b DEFAULT(white);\n" + code),
                HasSubstr("a.glsl:2: texture b"));
    EXPECT_THAT(message("vec3 shade(Point p, Surface s, Light light) { return s.base; }\n"),
                HasSubstr("has no surface()"));
    EXPECT_THAT(message("// vec3 shade(\nSurface surface(Point p) { return gltf_surface(p); }"),
                HasSubstr("has no shade()"));
    EXPECT_EQ(message(code), "nothing");
}

TEST(MaterialShader, BuiltInOnesAreThereAndDescribed) {
    for (const char* name :
         {"metallic-roughness", "blinn-phong", "skin", "minnaert", "reflection", "fresnel-rim", "detailed"}) {
        const auto shader = find_material_shader(name);
        ASSERT_TRUE(shader) << name;
        EXPECT_FALSE(shader->description.empty()) << name;
    }
    EXPECT_FALSE(find_material_shader("toon"));
}

std::string check_message(const Material& material) {
    try {
        check_material(material, "scene.glb: material 3");
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing";
}

TEST(MaterialShader, ParametersAndTexturesOfAMaterialAreChecked) {
    Material material{.name = "face"};
    material.shader = find_material_shader("skin");
    material.parameters["roll_off"] = glm::vec4(0.2f);
    EXPECT_EQ(check_message(material), "nothing");
    material.parameters["roll_off"] = glm::vec4(2.5f);
    EXPECT_EQ(check_message(material), "scene.glb: material 3: parameter roll_off of skin: 2.5 is outside 0 … 2");
    material.parameters = {{"rolloff", glm::vec4(0.2f)}};
    EXPECT_THAT(check_message(material), HasSubstr("scene.glb: material 3: skin has no parameter rolloff (roll_off"));
    material.parameters = {};
    material.textures["gloss_map"] = TextureRef{.image = 0};
    EXPECT_THAT(check_message(material), HasSubstr("skin has no texture gloss_map (none)"));
    material.textures = {};
    material.shader = parse_material_shader("a", "a", "TEXTURE_COLOUR(0) tint DEFAULT(required);\n" + code);
    EXPECT_THAT(check_message(material), HasSubstr("a needs a texture tint"));
}

TEST(MaterialShader, IsAssignedByTheMaterialsName) {
    Scene scene;
    scene.name = "scene.glb";
    scene.materials = {{.name = "wall"}, {.name = "floor"}};
    assign_material_shader(scene, "floor", find_material_shader("minnaert"));
    EXPECT_FALSE(scene.materials[0].shader);
    EXPECT_EQ(scene.materials[1].shader->name, "minnaert");
    try {
        assign_material_shader(scene, "roof", find_material_shader("minnaert"));
        ADD_FAILURE() << "there is no roof";
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "--material roof: scene.glb has no such material (wall, floor)");
    }
}

} // namespace
} // namespace prelight
