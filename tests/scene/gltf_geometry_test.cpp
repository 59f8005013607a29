#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace prelight;
using namespace prelight::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

const Primitive& only_primitive(const Scene& scene) { return scene.meshes.at(0).primitives.at(0); }

TEST(GltfGeometry, TriangleWithoutNormalsGetsFlatOnes) {
    const Scene scene = GltfBuilder::triangle().load();
    const Primitive& p = only_primitive(scene);
    EXPECT_THAT(p.positions, ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(p.indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(p.normals, testing::Each(glm::vec3(0, 0, 1)));
    EXPECT_THAT(p.tangents, SizeIs(0));
    EXPECT_EQ(scene.materials.at(p.material).name, "default");
    EXPECT_THAT(scene.warnings, SizeIs(0));
}

TEST(GltfGeometry, FlatNormalsUnshareVerticesAndDropGivenTangents) {
    GltfBuilder b;
    const size_t p = b.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
    const size_t t = b.add_floats({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, "VEC4");
    const size_t uv = b.add_floats({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2");
    const size_t i = b.add_values<uint16_t>({0, 1, 2, 0, 3, 1}, 5123, "SCALAR");
    b.add_image(png(1, 1, solid(1, 1, {128, 128, 255, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"] = Json::array({{{"normalTexture", {{"index", 0}}}}});
    b.json["meshes"] = Json::array(
        {{{"primitives", Json::array({{{"attributes", {{"POSITION", p}, {"TANGENT", t}, {"TEXCOORD_0", uv}}},
                                       {"indices", i},
                                       {"material", 0}}})}}});
    b.json["nodes"] = Json::array({{{"mesh", 0}}});
    const Scene scene = b.load();
    const Primitive& out = only_primitive(scene);
    ASSERT_THAT(out.positions, SizeIs(6));
    EXPECT_EQ(out.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(out.normals[3], glm::vec3(0, 1, 0));
    // Made anew: the given (0, 1, 0) would lie along the second triangle's normal.
    ASSERT_THAT(out.tangents, SizeIs(6));
    EXPECT_NEAR(out.tangents[0].x, 1, 1e-6);
}

TEST(GltfGeometry, GivenTangentsAreKeptOnlyForANormalMap) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.attributes()["TANGENT"] = b.add_floats({0, 2, 0, -1, 0, 2, 0, -1, 0, 2, 0, -1}, "VEC4");
    EXPECT_THAT(only_primitive(b.load()).tangents, SizeIs(0));
    b.add_image(png(1, 1, solid(1, 1, {128, 128, 255, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["normalTexture"]["index"] = 0;
    EXPECT_THAT(only_primitive(b.load()).tangents, testing::Each(glm::vec4(0, 1, 0, -1)));
    b.attributes().erase("TANGENT");
    // v grows with y here, so the image's up (green) is −y: w · (N × T) with w = −1.
    EXPECT_THAT(only_primitive(b.load()).tangents, testing::Each(glm::vec4(1, 0, 0, -1)));
}

TEST(GltfGeometry, NormalsBecomeUnitAndZeroOnesComeFromTriangles) {
    GltfBuilder b = GltfBuilder::triangle();
    b.attributes()["NORMAL"] = b.add_floats({0, 0, 5, 0, 3, 4, 0, 0, 0}, "VEC3");
    const Scene scene = b.load();
    EXPECT_THAT(only_primitive(scene).normals,
                ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0.6f, 0.8f), glm::vec3(0, 0, 1)));
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("zero normals")));
}

struct IndexType {
    int component;
    size_t size;
};
class GltfIndices : public testing::TestWithParam<IndexType> {};

TEST_P(GltfIndices, ReadsEveryType) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    Bytes bytes;
    for (const uint8_t index : {2, 0, 1}) {
        bytes.push_back(index);
        bytes.resize(bytes.size() + GetParam().size - 1);
    }
    b.primitive()["indices"] = b.add_accessor(
        {{"bufferView", b.add_view(bytes)}, {"componentType", GetParam().component}, {"type", "SCALAR"}, {"count", 3}});
    EXPECT_THAT(only_primitive(b.load()).indices, ElementsAre(2, 0, 1));
}
INSTANTIATE_TEST_SUITE_P(All, GltfIndices, testing::Values(IndexType{5121, 1}, IndexType{5123, 2}, IndexType{5125, 4}));

Scene five_points(int mode, bool indexed) {
    GltfBuilder b = GltfBuilder::triangle();
    b.attributes()["POSITION"] = b.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3");
    b.attributes()["NORMAL"] = b.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    b.primitive()["mode"] = mode;
    if (indexed)
        b.primitive()["indices"] = b.add_values<uint8_t>({0, 1, 2, 3, 4}, 5121, "SCALAR");
    return b.load();
}

TEST(GltfGeometry, EveryModeThatMakesTriangles) {
    for (const bool indexed : {false, true}) {
        EXPECT_THAT(only_primitive(five_points(4, indexed)).indices, ElementsAre(0, 1, 2));
        EXPECT_THAT(only_primitive(five_points(5, indexed)).indices, ElementsAre(0, 1, 2, 1, 3, 2, 2, 3, 4));
        EXPECT_THAT(only_primitive(five_points(6, indexed)).indices, ElementsAre(1, 2, 0, 2, 3, 0, 3, 4, 0));
    }
}

TEST(GltfGeometry, PointsAndLinesAreSkippedAndCounted) {
    GltfBuilder b = GltfBuilder::triangle();
    for (int mode = 0; mode < 4; ++mode) {
        Json primitive = b.primitive();
        primitive["mode"] = mode;
        b.json["meshes"][0]["primitives"].push_back(primitive);
    }
    const Scene scene = b.load();
    EXPECT_THAT(scene.meshes[0].primitives, SizeIs(1));
    EXPECT_THAT(scene.warnings, ElementsAre("test.glb: mesh 0 primitive 1: points and lines are not "
                                            "drawn (4 in all)"));
}

TEST(GltfGeometry, OnlyTheVerticesThatTrianglesUseAreKept) {
    GltfBuilder b = GltfBuilder::triangle();
    std::vector<float> positions(3 * 1000);
    for (size_t i = 0; i < 1000; ++i)
        positions[3 * i] = float(i), positions[3 * i + 1] = float(i % 2);
    b.attributes()["POSITION"] = b.add_floats(positions, "VEC3");
    b.attributes()["NORMAL"] = b.add_floats(std::vector<float>(3000, 1), "VEC3");
    b.primitive()["indices"] = b.add_values<uint16_t>({999, 500, 7, 7, 500, 8}, 5123, "SCALAR");
    const Scene scene = b.load();
    const Primitive& p = only_primitive(scene);
    EXPECT_THAT(p.positions,
                ElementsAre(glm::vec3(7, 1, 0), glm::vec3(8, 0, 0), glm::vec3(500, 0, 0), glm::vec3(999, 1, 0)));
    EXPECT_THAT(p.indices, ElementsAre(3, 2, 0, 0, 2, 1));
}

TEST(GltfGeometry, StridedAndOffsetAttributesShareAView) {
    GltfBuilder b = GltfBuilder::triangle();
    const std::vector<float> mixed = {9, 0, 0, 0, 0, 0, 1, 9, 1, 0, 0, 0, 0, 1, 9, 0, 1, 0, 0, 0, 1};
    const size_t view = b.add_view(bytes_of(mixed), 28);
    const Json vec3 = {{"bufferView", view}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 3}};
    Json position = vec3, normal = vec3;
    position["byteOffset"] = 4;
    normal["byteOffset"] = 16;
    b.attributes() = {{"POSITION", b.add_accessor(position)}, {"NORMAL", b.add_accessor(normal)}};
    const Primitive p = only_primitive(b.load());
    EXPECT_THAT(p.positions, ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(p.normals, testing::Each(glm::vec3(0, 0, 1)));
}

TEST(GltfGeometry, SparseAccessorsReplaceElements) {
    GltfBuilder b = GltfBuilder::triangle();
    const size_t places = b.add_view({1});
    const size_t values = b.add_view(bytes_of<float>({5, 6, 7}));
    const Json sparse = {{"count", 1},
                         {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                         {"values", {{"bufferView", values}}}};
    b.json["accessors"][0]["sparse"] = sparse;
    EXPECT_EQ(only_primitive(b.load()).positions.at(1), glm::vec3(5, 6, 7));
    b.json["accessors"][0].erase("bufferView"); // all zero but the one
    EXPECT_THAT(only_primitive(b.load()).positions, ElementsAre(glm::vec3(0), glm::vec3(5, 6, 7), glm::vec3(0)));
}

TEST(GltfGeometry, NormalisedIntegersOfEveryType) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    const auto set_colour = [&b](size_t accessor) {
        b.json["accessors"][accessor]["normalized"] = true;
        b.attributes()["COLOR_0"] = accessor;
        return only_primitive(b.load()).colours;
    };
    EXPECT_THAT(set_colour(b.add_values<uint8_t>({255, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 5121, "VEC4")),
                testing::Contains(glm::vec4(1, 0, 0.2f, 0)));
    EXPECT_THAT(set_colour(b.add_values<uint16_t>({65535, 0, 13107, 0, 0, 0, 0, 0, 0}, 5123, "VEC3")),
                testing::Contains(glm::vec4(1, 0, 0.2f, 1)));
    EXPECT_THAT(set_colour(b.add_floats({2, -1, 0.5f, 0, 0, 0, 0, 0, 0}, "VEC3")),
                testing::Contains(glm::vec4(1, 0, 0.5f, 1)));
    const size_t normal = b.add_values<int8_t>({0, 0, 127, 0, 0, 0, -128, 0, 0, -127, 0, 0}, 5120, "VEC4");
    b.json["accessors"][normal]["type"] = "VEC3";
    b.json["bufferViews"].back()["byteStride"] = 4;
    b.json["accessors"][normal]["normalized"] = true;
    b.attributes()["NORMAL"] = normal;
    EXPECT_THAT(only_primitive(b.load()).normals,
                ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(0, -1, 0)));
}

TEST(GltfGeometry, QuantisedPositionsAndTextureCoordinates) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    b.attributes()["POSITION"] = b.add_values<int16_t>({-5, 0, 0, 0, 300, 0, 0, 0, 0, 7, 0, 0}, 5122, "VEC4");
    b.json["accessors"].back()["type"] = "VEC3";
    b.json["bufferViews"].back()["byteStride"] = 8;
    b.attributes()["TEXCOORD_0"] = b.add_values<uint16_t>({0, 0, 65535, 0, 0, 13107}, 5123, "VEC2");
    b.json["accessors"].back()["normalized"] = true;
    b.attributes()["TEXCOORD_1"] = b.add_values<int8_t>({-2, 3, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 5120, "VEC4");
    b.json["accessors"].back()["type"] = "VEC2";
    b.json["bufferViews"].back()["byteStride"] = 4;
    const Primitive p = only_primitive(b.load());
    EXPECT_THAT(p.positions, ElementsAre(glm::vec3(-5, 0, 0), glm::vec3(300, 0, 0), glm::vec3(0, 7, 0)));
    EXPECT_THAT(p.texcoords[0], ElementsAre(glm::vec2(0), glm::vec2(1, 0), glm::vec2(0, 0.2f)));
    EXPECT_THAT(p.texcoords[1], ElementsAre(glm::vec2(-2, 3), glm::vec2(1, 0), glm::vec2(0, 1)));
}

TEST(GltfGeometry, MissingTextureCoordinatesAreZeroWithAWarning) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.attributes().erase("TEXCOORD_0");
    b.add_image(png(1, 1, solid(1, 1, {1, 2, 3, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["emissiveTexture"]["index"] = 0;
    const Scene scene = b.load();
    EXPECT_THAT(only_primitive(scene).texcoords[0], testing::Each(glm::vec2(0)));
    EXPECT_THAT(scene.warnings, SizeIs(1));
}

} // namespace
