// Accessors of a kind that glTF does not allow for their use, vectors that are none, and keyframes out of order:
// read rightly with a warning that names the accessor, or refused; never silently used.
#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <scene/animate.hpp>

namespace prelight {
namespace {

using namespace prelight::test;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125;

template <class T>
GltfBuilder with(const char* attribute, const std::vector<T>& values, int component, const char* type) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.attributes()[attribute] = b.add_values(values, component, type);
    return b;
}

/// Of the accessor that `with` adds: the fourth of the file.
template <class T>
Primitive read_with(const char* attribute, const std::vector<T>& values, int component, const char* type,
                    const std::string& warning) {
    return expect_repaired(with(attribute, values, component, type),
                           std::string("mesh 0 primitive 0: ") + attribute + ": accessor 3 holds " + warning)
        .meshes.at(0)
        .primitives.at(0);
}

TEST(GltfKinds, ColoursThatAreNotNormalizedAreReadAsSuch) {
    const std::string end = ", not VEC3 of floats or normalized unsigned bytes or shorts; they are read as normalized";
    const std::vector<uint16_t> shorts = {65535, 0, 13107, 65535, 0, 65535, 0, 65535, 0, 0, 65535, 0};
    EXPECT_THAT(read_with("COLOR_0", shorts, u16, "VEC4", "VEC4 of unsigned shorts" + end).colours,
                ElementsAre(glm::vec4(1, 0, 0.2f, 1), glm::vec4(0, 1, 0, 1), glm::vec4(0, 0, 1, 0)));
    const std::vector<uint8_t> bytes = {255, 0, 51, 255, 0, 255, 0, 255, 0, 0, 255, 255};
    EXPECT_THAT(read_with("COLOR_0", bytes, u8, "VEC4", "VEC4 of unsigned bytes" + end).colours[0],
                glm::vec4(1, 0, 0.2f, 1));
    EXPECT_THAT(read_with("COLOR_0", std::vector<int16_t>{32767, 0, 0, 0, 32767, 0, 0, 0, 32767, 0, 0, 0}, i16, "VEC4",
                          "VEC4 of shorts" + end)
                    .colours[0],
                glm::vec4(1, 0, 0, 0));
    GltfBuilder good = with("COLOR_0", shorts, u16, "VEC4");
    good.json["accessors"].back()["normalized"] = true;
    const Scene scene = good.load();
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.meshes[0].primitives[0].colours[0], glm::vec4(1, 0, 0.2f, 1)) << "the same as without the flag";
    EXPECT_TRUE(read_with("COLOR_0", std::vector<uint32_t>(12, 7), u32, "VEC4", "VEC4 of unsigned ints, not VEC3 of")
                    .colours.empty());
    EXPECT_TRUE(
        read_with("COLOR_0", std::vector<float>(6, 0.5f), 5126, "VEC2", "VEC2 of floats, not VEC3 of").colours.empty());
}

TEST(GltfKinds, TextureCoordinatesThatAreNotNormalized) {
    const std::vector<uint16_t> shorts = {0, 0, 65535, 0, 0, 13107};
    const Primitive read = read_with("TEXCOORD_0", shorts, u16, "VEC2",
                                     "VEC2 of unsigned shorts, not VEC2 of floats or normalized unsigned bytes or "
                                     "shorts; they are read as normalized");
    EXPECT_THAT(read.texcoords[0], ElementsAre(glm::vec2(0), glm::vec2(1, 0), glm::vec2(0, 0.2f)));
    GltfBuilder quantized = with("TEXCOORD_0", shorts, u16, "VEC2");
    quantized.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    const Scene scene = quantized.load();
    EXPECT_TRUE(scene.warnings.empty()) << "the extension means them as they are";
    EXPECT_EQ(scene.meshes[0].primitives[0].texcoords[0][1], glm::vec2(65535, 0));
    EXPECT_THAT(read_with("TEXCOORD_0", std::vector<float>{0, 0, 9, 1, 0, 9, 0, 1, 9}, 5126, "VEC3",
                          "VEC3 of floats, not VEC2 of")
                    .texcoords[0],
                ElementsAre(glm::vec2(0), glm::vec2(1, 0), glm::vec2(0, 1)));
    EXPECT_TRUE(read_with("TEXCOORD_1", std::vector<float>{0, 1, 0}, 5126, "SCALAR", "SCALAR of floats, not VEC2 of")
                    .texcoords[1]
                    .empty());
}

TEST(GltfKinds, PositionsAndNormals) {
    const std::vector<int16_t> shorts = {0, 0, 0, 0, 300, 0, 0, 0, 0, 7, 0, 0}; // padded to 8 bytes
    GltfBuilder b = with("POSITION", shorts, i16, "VEC4");
    b.json["accessors"].back()["type"] = "VEC3";
    b.json["bufferViews"].back()["byteStride"] = 8;
    const Scene scene = expect_repaired(
        b, "mesh 0 primitive 0: POSITION: accessor 3 holds VEC3 of shorts, not VEC3 of floats; their values count");
    EXPECT_EQ(scene.meshes[0].primitives[0].positions[1], glm::vec3(300, 0, 0));
    EXPECT_EQ(read_with("POSITION", std::vector<float>{0, 0, 0, 1, 2, 0, 0, 1, 0, 2, 0, 1}, 5126, "VEC4",
                        "VEC4 of floats, not VEC3 of floats; of each the first 3 count")
                  .positions[1],
              glm::vec3(2, 0, 0));
    EXPECT_EQ(error_of(with("POSITION", std::vector<uint32_t>(9, 1), u32, "VEC3")),
              "test.glb: mesh 0 primitive 0: POSITION: accessor 3 holds VEC3 of unsigned ints, not VEC3 of floats");
    GltfBuilder bytes = with("NORMAL", std::vector<int8_t>{0, 0, 127, 0, 0, 0, 127, 0, 0, 127, 0, 0}, i8, "VEC4");
    bytes.json["accessors"].back()["type"] = "VEC3";
    bytes.json["bufferViews"].back()["byteStride"] = 4;
    EXPECT_EQ(
        expect_repaired(
            bytes,
            "mesh 0 primitive 0: NORMAL: accessor 3 holds VEC3 of bytes, not VEC3 of floats; their directions count")
            .meshes[0]
            .primitives[0]
            .normals[2],
        glm::vec3(0, 1, 0));
    EXPECT_THAT(read_with("NORMAL", std::vector<uint8_t>(12, 9), u8, "VEC4",
                          "VEC4 of unsigned bytes, not VEC3 of floats; it is left out")
                    .normals,
                Each(glm::vec3(0, 0, 1)));
    GltfBuilder flag = with("NORMAL", std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3");
    flag.json["accessors"].back()["normalized"] = true;
    expect_repaired(flag, "mesh 0 primitive 0: NORMAL: accessor 3 holds VEC3 of normalized floats");
}

TEST(GltfKinds, Indices) {
    GltfBuilder b = GltfBuilder::triangle();
    b.primitive()["indices"] = b.add_values<uint16_t>({0, 1, 2}, u16, "SCALAR");
    b.json["accessors"].back()["normalized"] = true;
    EXPECT_THAT(expect_repaired(b, "mesh 0 primitive 0: accessor 1 holds SCALAR of normalized unsigned shorts")
                    .meshes[0]
                    .primitives[0]
                    .indices,
                ElementsAre(0, 1, 2));
    b.primitive()["indices"] = b.add_floats({0, 1, 2}, "SCALAR");
    EXPECT_THAT(error_of(b),
                HasSubstr("mesh 0 primitive 0: accessor 2 holds SCALAR of floats, not SCALAR of unsigned integers"));
    b.primitive()["indices"] = b.add_values<int16_t>({0, 1, 2}, i16, "SCALAR");
    EXPECT_THAT(error_of(b), HasSubstr("accessor 3 holds SCALAR of shorts, not"));
}

/// Two joints, the second 8 m up in z; `joints` and `weights` of the three vertices.
template <class J, class W>
GltfBuilder skinned(const std::vector<J>& joints, int joint_component, const std::vector<W>& weights,
                    int weight_component) {
    GltfBuilder b = with("JOINTS_0", joints, joint_component, "VEC4");
    b.attributes()["WEIGHTS_0"] = b.add_values(weights, weight_component, "VEC4");
    b.json["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}, Json::object(), {{"translation", {0, 0, 8}}}});
    b.json["skins"] = Json::array({{{"joints", {1, 2}}}});
    b.json["scenes"][0]["nodes"] = {0, 1, 2};
    return b;
}

float height_of(const GltfBuilder& builder, const std::string& warning) {
    const Scene scene = expect_repaired(builder, "mesh 0 primitive 0: " + warning);
    return float(resolve(scene).bounds_max.z);
}

TEST(GltfKinds, JointsAndWeights) {
    const std::vector<uint8_t> joints = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    const std::vector<float> whole = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    const auto all = [](float first, float second) {
        std::vector<float> out;
        for (int i = 0; i < 3; ++i)
            out.insert(out.end(), {first, second, 0, 0});
        return out;
    };
    EXPECT_TRUE(skinned(joints, u8, whole, 5126).load().warnings.empty());
    EXPECT_EQ(height_of(skinned(joints, u8, std::vector<uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, u8),
                        "WEIGHTS_0: accessor 4 holds VEC4 of unsigned bytes"),
              8);
    EXPECT_EQ(height_of(skinned(joints, u8,
                                std::vector<uint16_t>{49151, 16384, 0, 0, 49151, 16384, 0, 0, 49151, 16384, 0, 0}, u16),
                        "WEIGHTS_0: accessor 4 holds VEC4 of unsigned shorts"),
              float(8.0 * 49151 / 65535));
    EXPECT_EQ(height_of(skinned(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 5126, whole, 5126),
                        "JOINTS_0: accessor 3 holds VEC4 of floats"),
              8);
    EXPECT_EQ(height_of(skinned(std::vector<uint32_t>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, u32, whole, 5126),
                        "JOINTS_0: accessor 3 holds VEC4 of unsigned ints"),
              8);
    GltfBuilder normalized = skinned(joints, u8, whole, 5126);
    normalized.json["accessors"][3]["normalized"] = true;
    EXPECT_EQ(height_of(normalized, "JOINTS_0: accessor 3 holds VEC4 of normalized unsigned bytes"), 8);
    // Weights that do not sum up to 1, that are below 0, that are no numbers, and none at all.
    EXPECT_EQ(height_of(skinned(joints, u8, all(1.5f, 0.5f), 5126),
                        "WEIGHTS: those of vertex 0 sum up to 2 instead of 1; they are scaled"),
              6);
    EXPECT_EQ(height_of(skinned(joints, u8, all(1, -1), 5126), "WEIGHTS_0: vertex 0 has a negative weight; 0 is used"),
              8);
    EXPECT_EQ(
        height_of(skinned(joints, u8, all(1, no_number), 5126), "WEIGHTS_0: vertex 0 is not finite; its weights are 0"),
        0);
    EXPECT_EQ(height_of(skinned(joints, u8, all(0, 0), 5126),
                        "WEIGHTS: vertex 0 has none; it follows the skin's first joint"),
              0);
    EXPECT_TRUE(skinned(joints, u8, all(0.504f, 0.5f), 5126).load().warnings.empty()) << "as exporters round";
}

TEST(GltfVectors, NormalsThatAreNoNumbersAreMadeAnew) {
    for (const float bad : {no_number, std::numeric_limits<float>::infinity(), 0.f}) {
        const Scene scene = expect_repaired(
            with("NORMAL", std::vector<float>{1, 0, 0, bad, bad, bad, 0, 0, 1}, 5126, "VEC3"),
            "mesh 0 primitive 0: NORMAL: zero normals and those that are not finite are taken from the triangles");
        EXPECT_THAT(scene.meshes[0].primitives[0].normals,
                    ElementsAre(glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)));
    }
    std::vector<float> normals(1500, no_number); // 500 of them are one line
    GltfBuilder b = GltfBuilder::triangle();
    std::vector<float> positions;
    for (int i = 0; i < 500; ++i)
        positions.insert(positions.end(), {float(i), float(i * i), 0});
    b.attributes() = {{"POSITION", b.add_floats(positions, "VEC3")}, {"NORMAL", b.add_floats(normals, "VEC3")}};
    const Scene scene = b.load();
    EXPECT_THAT(scene.warnings, ElementsAre("test.glb: mesh 0 primitive 0: NORMAL: zero normals and those that are not "
                                            "finite are taken from the triangles (498 in all)"));
}

TEST(GltfVectors, TangentsThatAreNoNumbersAreMadeAnew) {
    GltfBuilder b = with("TANGENT", std::vector<float>{0, 1, 0, 1, no_number, 1, 0, 1, 0, 1, 0, 1}, 5126, "VEC4");
    b.add_image(png(1, 1, solid(1, 1, {128, 128, 255, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["normalTexture"]["index"] = 0;
    const Scene scene = b.load();
    EXPECT_EQ(scene.warnings.size(), 1u);
    EXPECT_THAT(scene.meshes[0].primitives[0].tangents, Each(glm::vec4(1, 0, 0, -1)));
}

TEST(GltfVectors, OthersThatAreNoNumbers) {
    const auto start = [](const char* name) {
        return std::string("mesh 0 primitive 0: ") + name + ": vertex 1 is not finite; ";
    };
    const auto primitive = [](const GltfBuilder& b, const std::string& warning) {
        return expect_repaired(b, warning).meshes.at(0).primitives;
    };
    EXPECT_EQ(primitive(with("TEXCOORD_0", std::vector<float>{0, 0, no_number, 0, 0, 1}, 5126, "VEC2"),
                        start("TEXCOORD_0") + "(0, 0) is used")[0]
                  .texcoords[0][1],
              glm::vec2(0));
    EXPECT_EQ(primitive(with("COLOR_0", std::vector<float>{0, 0, 0, 0, no_number, 0, 0, 0, 0}, 5126, "VEC3"),
                        start("COLOR_0") + "white is used")[0]
                  .colours[1],
              glm::vec4(1));
    EXPECT_TRUE(primitive(with("POSITION", std::vector<float>{0, 0, 0, no_number, 0, 0, 0, 1, 0}, 5126, "VEC3"),
                          start("POSITION") + "the triangles at it are left out")
                    .empty());
    GltfBuilder four = with("POSITION", std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, no_number, 1, 0}, 5126, "VEC3");
    four.attributes() = {{"POSITION", four.attributes()["POSITION"]}};
    four.primitive()["indices"] = four.add_values<uint8_t>({0, 1, 2, 1, 3, 2}, u8, "SCALAR");
    EXPECT_EQ(primitive(four, "mesh 0 primitive 0: POSITION: vertex 3 is not finite")[0].indices.size(), 3u)
        << "the other triangle stays";
}

/// Node 0 moved along x by keyframes.
GltfBuilder moving(const std::vector<float>& times, const std::vector<float>& x, const char* interpolation = "LINEAR") {
    GltfBuilder b = GltfBuilder::triangle();
    std::vector<float> values;
    for (const float v : x)
        values.insert(values.end(), {v, 0, 0});
    b.json["animations"] = Json::array(
        {{{"samplers", Json::array({{{"input", b.add_floats(times, "SCALAR")},
                                     {"output", b.add_floats(values, "VEC3")},
                                     {"interpolation", interpolation}}})},
          {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})}}});
    return b;
}

double x_at(const Scene& scene, double time) { return resolve(scene, {}, Moment{time}).instances.at(0).transform[3].x; }

TEST(GltfKeyframes, AtOneTimeAreAJump) {
    const Scene twice = expect_repaired(moving({0, 1, 1, 2}, {-1, 0, 1, 1}),
                                        "animation 0 sampler 0: keyframe 2 (at 1 s) is at the time of another");
    EXPECT_NEAR(x_at(twice, 0.5), -0.5, 1e-6);
    EXPECT_NEAR(x_at(twice, 1.5), 1, 1e-6);
    const Scene often = moving({0, 1, 1, 1, 1, 3}, {0, 1, 50, 60, 2, 4}).load();
    EXPECT_NEAR(x_at(often, 0.5), 0.5, 1e-6);
    EXPECT_NEAR(x_at(often, 2), 3, 1e-5) << "the first and the last of them count";
    EXPECT_NEAR(x_at(moving({0, 0, 2}, {9, 1, 3}).load(), 1), 2, 1e-6) << "at the start";
    EXPECT_NEAR(x_at(moving({0, 2, 2}, {1, 3, 9}).load(), 1), 2, 1e-6) << "at the end";
    EXPECT_NEAR(x_at(moving({1, 1}, {1, 3}).load(), 2), 3, 1e-6) << "all of them";
    const Scene steps = moving({0, 1, 1, 2}, {1, 2, 3, 4}, "STEP").load();
    EXPECT_NEAR(x_at(steps, 0.5), 1, 1e-9);
    EXPECT_NEAR(x_at(steps, 1.5), 3, 1e-9);
}

TEST(GltfKeyframes, OutOfOrderAreSorted) {
    const Scene scene = expect_repaired(
        moving({0, 2, 1, 3}, {0, 4, 1, 9}),
        "animation 0 sampler 0: keyframe 2 (at 1 s) is before the one that it follows; they are sorted by time");
    EXPECT_NEAR(x_at(scene, 0.5), 0.5, 1e-6);
    EXPECT_NEAR(x_at(scene, 1.5), 2.5, 1e-6);
    EXPECT_NEAR(x_at(moving({3, 2, 1, 0}, {3, 2, 1, 0}).load(), 1.25), 1.25, 1e-6) << "backwards";
}

TEST(GltfKeyframes, ThatAreNoNumbersAreLeftOut) {
    const Scene value = expect_repaired(moving({0, 1, 2}, {0, no_number, 4}),
                                        "animation 0 sampler 0: keyframe 1 (at 1 s) is not finite; it is left out");
    EXPECT_NEAR(x_at(value, 1), 2, 1e-6);
    EXPECT_NEAR(x_at(moving({0, no_number, 2}, {0, 7, 4}).load(), 1), 2, 1e-6);
    const Scene none = expect_repaired(moving({no_number, no_number}, {0, 1}), "animation 0 sampler 0: keyframe 0");
    EXPECT_TRUE(none.animations[0].channels.empty()) << "none is left";
    const Scene before = expect_repaired(moving({-1, 1}, {0, 2}),
                                         "animation 0 sampler 0: keyframe 0 (at -1 s) is before 0 s; it counts");
    EXPECT_NEAR(x_at(before, 0), 1, 1e-6);
    EXPECT_NEAR(x_at(moving({0, 1, 1, 2}, {0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0}, "CUBICSPLINE").load(), 1.5), 2.5, 1e-5);
}

TEST(GltfKeyframes, RotationsAreMadeUnit) {
    GltfBuilder b = moving({0, 1}, {0, 0});
    b.json["animations"][0]["samplers"][0]["output"] = b.add_floats({0, 0, 0, 2, 0, 0, 3, 0}, "VEC4");
    b.json["animations"][0]["channels"][0]["target"]["path"] = "rotation";
    const Scene scene = expect_repaired(
        b, "animation 0 sampler 0: output: the quaternion of keyframe 0 is no unit one; it is made one");
    EXPECT_NEAR(resolve(scene, {}, Moment{0.5}).instances.at(0).transform[0].y, 1, 1e-6) << "half of half a turn";
    b.json["animations"][0]["samplers"][0]["output"] =
        b.add_values<int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}, i16, "VEC4");
    const Scene shorts = expect_repaired(b, "animation 0 sampler 0: output: accessor 4 holds VEC4 of shorts, not VEC4 "
                                            "of floats or normalized bytes or shorts; they are read as normalized");
    EXPECT_NEAR(resolve(shorts, {}, Moment{0.5}).instances.at(0).transform[0].y, 1, 1e-6);
}

} // namespace
} // namespace prelight
