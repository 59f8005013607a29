#include <cstring>
#include <fstream>
#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <scene/oracle.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/writer_scenes.hpp>

namespace prelight {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A .glb taken apart by hand, not by the project's reader.
struct Glb {
    json tree;
    std::string binary;
};

uint32_t word(const std::string& bytes, size_t at) {
    uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

Glb parse(const std::string& bytes) {
    Glb glb;
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(bytes, 4), 2u);
    EXPECT_EQ(word(bytes, 8), bytes.size());
    const uint32_t length = word(bytes, 12);
    EXPECT_EQ(length % 4, 0u);
    glb.tree = json::parse(bytes.substr(20, length));
    if (20 + length < bytes.size()) {
        EXPECT_EQ(word(bytes, 20 + length) % 4, 0u);
        EXPECT_EQ(bytes.size(), 28 + length + word(bytes, 20 + length));
        glb.binary = bytes.substr(28 + length);
    }
    return glb;
}

class Writer : public testing::Test {
protected:
    oracle::TemporaryFolder folder;

    Glb write(const Scene& scene) {
        save_glb(scene, folder.path / "scene.glb");
        return parse(read_file(folder.path / "scene.glb"));
    }
    std::string message(const Scene& scene, const fs::path& path) {
        try {
            save_glb(scene, path);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }
    /// What the writer says of a scene that it refuses; nothing may be left in the folder.
    std::string refusal(const Scene& scene) {
        const std::string text = message(scene, folder.path / "refused.glb");
        EXPECT_TRUE(fs::is_empty(folder.path));
        EXPECT_EQ(text.find('\n'), std::string::npos);
        return text;
    }
};

Scene minimal() {
    Scene scene;
    scene.scenes = {{.name = {}, .nodes = {}}};
    scene.materials = {{}};
    return scene;
}

TEST_F(Writer, SameSceneSameBytes) {
    save_glb(scene_with_everything(), folder.path / "a.glb");
    save_glb(scene_with_everything(), folder.path / "b.glb");
    EXPECT_EQ(read_file(folder.path / "a.glb"), read_file(folder.path / "b.glb"));
}

TEST_F(Writer, SceneOfNothingIsAFile) {
    const Glb glb = write(minimal());
    EXPECT_TRUE(glb.binary.empty());
    EXPECT_EQ(glb.tree["asset"]["version"], "2.0");
    EXPECT_FALSE(glb.tree.contains("buffers"));
    EXPECT_FALSE(glb.tree.contains("extras"));
}

TEST_F(Writer, SamplersAndTexturesAreSharedBetweenMaterials) {
    const json tree = write(scene_with_everything()).tree;
    EXPECT_EQ(tree["samplers"].size(), 3u);
    EXPECT_EQ(tree["textures"].size(),
              4u); // images 0 and 1 plain, and two with samplers of their own
    EXPECT_EQ(tree["images"].size(), 2u);
    EXPECT_EQ(tree["samplers"][0],
              (json{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}}));
}

TEST_F(Writer, IndicesAreAsSmallAsTheMeshAllows) {
    const json tree = write(scene_with_everything()).tree;
    const auto type = [&](size_t mesh, size_t primitive) {
        const auto& accessor = tree["meshes"][mesh]["primitives"][primitive]["indices"];
        return tree["accessors"][accessor.get<size_t>()]["componentType"].get<int>();
    };
    EXPECT_EQ(type(0, 0), 5123);
    EXPECT_EQ(type(1, 0), 5125);
}

TEST_F(Writer, EmptyMeshesLeaveNoTrace) {
    const json tree = write(scene_with_everything()).tree;
    ASSERT_EQ(tree["meshes"].size(), 2u);
    EXPECT_EQ(tree["meshes"][0]["name"], "three");
    EXPECT_EQ(tree["meshes"][0]["primitives"].size(), 3u);
    for (const json& node : tree["nodes"]) {
        if (node.value("name", "") == "nothing") {
            EXPECT_FALSE(node.contains("mesh"));
        }
        if (node.value("name", "") == "ground") {
            EXPECT_EQ(node["mesh"], 1);
        }
    }
}

TEST_F(Writer, PositionsAreInTheBinaryChunk) {
    const Glb glb = write(scene_with_everything());
    const auto& attributes = glb.tree["meshes"][0]["primitives"][0]["attributes"];
    const auto& accessor = glb.tree["accessors"][attributes["POSITION"].get<size_t>()];
    const auto& view = glb.tree["bufferViews"][accessor["bufferView"].get<size_t>()];
    const Primitive expected = scene_with_everything().meshes[1].primitives[0];
    ASSERT_EQ(accessor["count"], expected.positions.size());
    EXPECT_EQ(std::memcmp(glb.binary.data() + view["byteOffset"].get<size_t>(), expected.positions.data(),
                          view["byteLength"].get<size_t>()),
              0);
    EXPECT_EQ(accessor["min"], (json{-0.5, -0.5, -0.5}));
    EXPECT_EQ(accessor["max"], (json{0.5, 0.5, 0.5}));
}

TEST_F(Writer, WhatGltfCannotSayIsInExtras) {
    const json tree = write(scene_with_everything()).tree;
    EXPECT_EQ(tree["extras"]["prelight"]["ambient"], (json{0.1, 0.2, 0.3}));
    const json& lights = tree["extensions"]["KHR_lights_punctual"]["lights"];
    EXPECT_FALSE(lights[0].contains("extras"));
    EXPECT_EQ(lights[2]["extras"]["prelight"],
              (json{{"falloff", "linear"}, {"shininess", 2.5}, {"castsShadow", false}}));
    EXPECT_EQ(lights[3]["extras"]["prelight"]["falloff"], "quadratic");
}

// Above 1 a colour moves to the intensity, as a power of two: the product is the same float.
TEST_F(Writer, BrightColoursMoveToTheIntensity) {
    const json tree = write(scene_with_everything()).tree;
    const json& light = tree["extensions"]["KHR_lights_punctual"]["lights"][2];
    EXPECT_EQ(light["color"][0].get<float>() * light["intensity"].get<float>(), 5 * 3.3f);
    EXPECT_EQ(light["color"][2].get<float>() * light["intensity"].get<float>(), 0.7f * 3.3f);
    EXPECT_EQ(light["color"][2].get<float>(), 0.7f / 8);
    EXPECT_LE(light["color"][0], 1);
    const json& material = tree["materials"][0];
    const json& strength = material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"];
    EXPECT_EQ(material["emissiveFactor"][1].get<float>() * strength.get<float>(), 3.7f);
    EXPECT_EQ(material["emissiveFactor"][2].get<float>() * strength.get<float>(), 12.1f);
}

TEST_F(Writer, TransformsKeepDoublePrecision) {
    const json tree = write(scene_with_everything()).tree;
    for (const json& node : tree["nodes"]) {
        if (node.value("name", "") == "far") {
            EXPECT_EQ(node["translation"], (json{10000.123456789, 0.001, -10000.5}));
        }
        if (node.value("name", "") == "mirrored") {
            EXPECT_EQ(node["matrix"].size(), 16u);
        }
        if (node.value("name", "") == "flat") {
            EXPECT_EQ(node["scale"][1], 0);
        }
    }
}

TEST_F(Writer, UnwritablePathsAreErrorsThatNameThem) {
    const fs::path nowhere = folder.path / "missing" / "scene.glb";
    EXPECT_NE(message(minimal(), nowhere).find(nowhere.string()), std::string::npos);
    EXPECT_NE(message(minimal(), folder.path).find(folder.path.string()), std::string::npos);
    EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST_F(Writer, RefusesWhatHasNoFormInGltf) {
    Scene shear = minimal();
    add_root(shear, "skew", glm::dmat4(1)).local[1][0] = 0.5;
    EXPECT_NE(refusal(shear).find("node 0 (skew): "), std::string::npos) << refusal(shear);

    Scene transform = minimal();
    add_root(transform, "nan", glm::dmat4(1)).local[3][0] = std::nan("");
    EXPECT_NE(refusal(transform).find("node 0 (nan): "), std::string::npos);

    Scene vertex = minimal();
    vertex.meshes = {scene_with_everything().meshes[1]};
    vertex.meshes[0].primitives[0].positions[3].y = std::nanf("");
    vertex.materials = scene_with_everything().materials;
    vertex.images = scene_with_everything().images;
    EXPECT_NE(refusal(vertex).find("mesh 0 (three): "), std::string::npos) << refusal(vertex);

    Scene camera = minimal();
    add_camera(camera, {.name = "plan", .kind = ProjectionKind::orthographic}, {0, 0, 1}, {0, 0, 0});
    EXPECT_NE(refusal(camera).find("camera 0 (plan): "), std::string::npos) << refusal(camera);

    Scene image = minimal();
    image.images = {{.name = "short", .width = 2, .height = 2, .rgba = {1, 2, 3, 4}}};
    EXPECT_NE(refusal(image).find("image 0 (short): "), std::string::npos) << refusal(image);

    Scene texture = scene_with_everything();
    texture.materials[0].normal_texture.uv_linear = {{1, 0}, {1, 1}};
    EXPECT_NE(refusal(texture).find("material 0 (everything): "), std::string::npos);

    Scene light = minimal();
    add_light(light, {.name = "dark", .intensity = -1}, {0, 0, 0});
    EXPECT_NE(refusal(light).find("light 0 (dark): "), std::string::npos);
}

class Validator : public Writer {
protected:
    void SetUp() override {
        if (!oracle::available("gltf-validator"))
            GTEST_SKIP() << oracle::missing("gltf-validator");
    }
    bool accepts(const Scene& scene) {
        const fs::path path = folder.path / "scene.glb";
        save_glb(scene, path);
        return oracle::run("validate.js", fmt::format("'{}'", path.string()));
    }
};

TEST_F(Validator, AcceptsEverything) {
    EXPECT_TRUE(accepts(scene_with_everything()));
    EXPECT_TRUE(accepts(minimal()));
}

TEST_F(Validator, AcceptsEveryBuiltinScene) {
    for (const BuiltinScene& scene : builtin_scenes())
        EXPECT_TRUE(accepts(make_scene(scene.name, scene.default_lights, 1))) << scene.name;
}

TEST_F(Validator, AcceptsAsManyLightsAsThereMayBe) { EXPECT_TRUE(accepts(make_scene("spheres", 65536, 1))); }

// The script itself must be able to say no.
TEST_F(Validator, RefusesADamagedFile) {
    const fs::path path = folder.path / "scene.glb";
    save_glb(scene_with_everything(), path);
    std::string bytes = read_file(path);
    bytes.replace(bytes.find("\"VEC3\""), 6, "\"VEC2\"");
    std::ofstream(path, std::ios::binary) << bytes;
    EXPECT_FALSE(oracle::run("validate.js", fmt::format("'{}' > /dev/null", path.string())));
}

} // namespace
} // namespace prelight
