#include "gltf_builder.hpp"
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>

using namespace prelight;
using namespace prelight::test;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

class GltfErrors : public testing::TestWithParam<Damage> {};

TEST_P(GltfErrors, OneLineThatNamesTheObject) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.primitive()["indices"] = b.add_values<uint16_t>({0, 1, 2}, 5123, "SCALAR");
    b.add_image(png(4, 4, solid(4, 4, {9, 9, 9, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["emissiveTexture"]["index"] = 0;
    expect_told(b, GetParam());
}

void set_position(GltfBuilder& b, float value) { std::memcpy(b.binary.data() + 12, &value, 4); }

constexpr size_t largest = std::numeric_limits<size_t>::max();

std::vector<Damage> damaged_files() {
    return {
        {"NoAsset", [](GltfBuilder& b) { b.json.erase("asset"); }, "asset: is missing"},
        {"Version1", [](GltfBuilder& b) { b.json["asset"]["version"] = "1.0"; },
         "asset: the file is glTF 1.0; only glTF 2.0 is read"},
        {"MinVersion", [](GltfBuilder& b) { b.json["asset"]["minVersion"] = "2.1"; }, "asset: the file needs glTF 2.1"},
        {"RequiredExtension", [](GltfBuilder& b) { b.json["extensionsRequired"] = {"VENDOR_new\nthing"}; },
         "extension VENDOR_new\\nthing: the file requires it"},
        {"TableNoArray", [](GltfBuilder& b) { b.json["nodes"] = 5; }, "JSON: nodes is not an array"},
        {"NodeNoObject", [](GltfBuilder& b) { b.json["nodes"][0] = 5; }, "node 0: is not a JSON object"},
        {"BufferTooShort", [](GltfBuilder& b) { b.json["buffers"][0]["byteLength"] = 100000; },
         "buffer 0: byteLength is 100000"},
        {"ViewBeyondBuffer", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteOffset"] = 100000; },
         "bufferView 0: its bytes 100000 + 36 lie beyond buffer 0"},
        {"ViewOverflows", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteOffset"] = largest - 4; },
         "bufferView 0: its bytes"},
        {"ViewWithoutBuffer", [](GltfBuilder& b) { b.json["bufferViews"][0]["buffer"] = 7; },
         "bufferView 0: buffer is 7, but there are 1"},
        {"ViewStride", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteStride"] = 1000; },
         "bufferView 0: byteStride 1000"},
        {"AccessorBeyondView", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 4; },
         "accessor 0: 4 elements of 12 bytes from byte 0 lie beyond bufferView 0 (36 bytes)"},
        {"AccessorCountHuge", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 0xfffffffe; },
         "accessor 0: 4294967294 elements"},
        {"AccessorCountOverflows", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = largest / 12 + 1; },
         "accessor 0: count"},
        {"AccessorOffsetOverflows", [](GltfBuilder& b) { b.json["accessors"][0]["byteOffset"] = largest - 3; },
         "accessor 0: 3 elements of 12 bytes from byte 18446744073709551612 lie beyond"},
        {"AccessorOffsetNegative", [](GltfBuilder& b) { b.json["accessors"][0]["byteOffset"] = -4; },
         "accessor 0: byteOffset is not a non-negative integer"},
        {"AccessorNoData",
         [](GltfBuilder& b) {
             b.json["accessors"][0] = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 4000000000u}};
             b.primitive().erase("indices");
         },
         "mesh 0 primitive 0: needs more memory"},
        {"AccessorType", [](GltfBuilder& b) { b.json["accessors"][0]["type"] = "MAT9"; }, "accessor 0: type \"MAT9\""},
        {"AccessorComponent", [](GltfBuilder& b) { b.json["accessors"][0]["componentType"] = 5124; },
         "accessor 0: componentType 5124"},
        {"AccessorMissing", [](GltfBuilder& b) { b.attributes()["POSITION"] = 99; },
         "mesh 0 primitive 0 attributes: POSITION is 99, but there are 4"},
        {"PositionsOfTwo", [](GltfBuilder& b) { b.attributes()["POSITION"] = 2; },
         "mesh 0 primitive 0: POSITION: accessor 2 holds VEC2 of floats, not VEC3 of floats"},
        {"AttributeOtherLength", [](GltfBuilder& b) { b.json["accessors"][1]["count"] = 2; },
         "mesh 0 primitive 0: NORMAL: has 2 values for 3 vertices"},
        {"IndexBeyondVertices", [](GltfBuilder& b) { b.binary[100] = 3; },
         "mesh 0 primitive 0: index 3 (number 2) is beyond its 3 vertices"},
        {"IndicesOfFloats", [](GltfBuilder& b) { b.primitive()["indices"] = 0; },
         "mesh 0 primitive 0: accessor 0 holds VEC3 of floats, not SCALAR of unsigned integers"},
        {"Mode", [](GltfBuilder& b) { b.primitive()["mode"] = 7; },
         "mesh 0 primitive 0: mode 7 is not known; the primitive is left out", true},
        {"PositionNan", [](GltfBuilder& b) { set_position(b, std::numeric_limits<float>::quiet_NaN()); },
         "mesh 0 primitive 0: POSITION: vertex 1 is not finite; the triangles at it are left out", true},
        {"PositionInfinite", [](GltfBuilder& b) { set_position(b, std::numeric_limits<float>::infinity()); },
         "mesh 0 primitive 0: POSITION: vertex 1 is not finite; the triangles at it are left out", true},
        {"SparseBeyond",
         [](GltfBuilder& b) {
             b.json["accessors"][0]["sparse"] = {
                 {"count", 1},
                 {"indices", {{"bufferView", b.add_view({9, 0, 0, 0})}, {"componentType", 5121}}},
                 {"values", {{"bufferView", 0}}}};
         },
         "accessor 0 sparse: index 9 is beyond its 3 elements"},
        {"SparseFalls",
         [](GltfBuilder& b) {
             b.json["accessors"][0]["sparse"] = {
                 {"count", 2},
                 {"indices", {{"bufferView", b.add_view({1, 1, 0, 0})}, {"componentType", 5121}}},
                 {"values", {{"bufferView", 0}}}};
         },
         "accessor 0 sparse: index 1 does not increase"},
        {"SparseCount",
         [](GltfBuilder& b) {
             b.json["accessors"][0]["sparse"] = {{"count", 4000000000u},
                                                 {"indices", {{"bufferView", 0}, {"componentType", 5121}}},
                                                 {"values", {{"bufferView", 0}}}};
         },
         "accessor 0 sparse: count 4000000000"},
        {"Cycle",
         [](GltfBuilder& b) {
             b.json["nodes"] = Json::array({Json::object(), {{"children", {2}}}, {{"children", {1}}}});
         },
         "node 1: is its own ancestor (cycle)"},
        {"OwnChild", [](GltfBuilder& b) { b.json["nodes"][0]["children"] = {0}; },
         "node 0: is its own ancestor (cycle)"},
        {"TwoParents",
         [](GltfBuilder& b) {
             b.json["nodes"] = Json::array({{{"children", {2}}}, {{"children", {2}}}, Json::object()});
         },
         "node 2: is a child of node 0 and of node 1"},
        {"ChildMissing", [](GltfBuilder& b) { b.json["nodes"][0]["children"] = {5}; },
         "node 0: children holds 5, but there are 1"},
        {"SceneNodeTwice",
         [](GltfBuilder& b) {
             b.json["scenes"][0]["nodes"] = {0, 0};
         },
         "scene 0: node 0 stands twice", true},
        {"SceneNodeNoRoot",
         [](GltfBuilder& b) {
             b.json["nodes"].push_back({{"children", {0}}});
         },
         "scene 0: node 0 is not a root"},
        {"SceneMissing", [](GltfBuilder& b) { b.json["scene"] = 3; }, "JSON: scene is 3, but there are 1"},
        {"MeshMissing", [](GltfBuilder& b) { b.json["nodes"][0]["mesh"] = 3; }, "node 0: mesh is 3"},
        {"TransformOverflows",
         [](GltfBuilder& b) {
             b.json["nodes"] =
                 Json::array({{{"mesh", 0}, {"scale", {1e200, 1, 1}}}, {{"children", {0}}, {"scale", {1e200, 1, 1}}}});
             b.json["scenes"][0]["nodes"] = {1};
         },
         "node 0: its world transform is not finite"},
        {"MatrixRow",
         [](GltfBuilder& b) { b.json["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; },
         "node 0: matrix: its last row", true},
        {"MatrixShort",
         [](GltfBuilder& b) {
             b.json["nodes"][0]["matrix"] = {1, 0};
         },
         "node 0: matrix is another array, not an array of 16 numbers; it is ignored", true},
        {"PictureCut", [](GltfBuilder& b) { b.json["bufferViews"].back()["byteLength"] = 50; },
         "image 0: does not decode", true},
        {"PictureNone", [](GltfBuilder& b) { b.json["images"][0]["bufferView"] = 0; },
         "image 0: is neither PNG, JPEG nor WebP", true},
        {"PictureBroken", [](GltfBuilder& b) { b.binary[b.binary.size() - 22] ^= 0xff; }, "image 0: does not decode",
         true},
        {"PictureViewMissing", [](GltfBuilder& b) { b.json["images"][0]["bufferView"] = 99; },
         "image 0: bufferView is 99"},
        {"PictureNoSource", [](GltfBuilder& b) { b.json["images"][0].erase("bufferView"); },
         "image 0: has neither uri nor bufferView", true},
        {"TextureMissing", [](GltfBuilder& b) { b.json["materials"][0]["emissiveTexture"]["index"] = 4; },
         "material 0 emissiveTexture: index is 4, but there are 1"},
        {"SourceMissing", [](GltfBuilder& b) { b.json["textures"][0]["source"] = 4; }, "texture 0: source is 4"},
        {"MaterialMissing", [](GltfBuilder& b) { b.primitive()["material"] = 4; }, "mesh 0 primitive 0: material is 4"},
        {"FactorText",
         [](GltfBuilder& b) {
             b.json["materials"][0]["emissiveFactor"] = {"a", 1, 1};
         },
         "material 0: emissiveFactor is another array, not an array of 3 numbers; it is ignored", true},
        {"AlphaMode", [](GltfBuilder& b) { b.json["materials"][0]["alphaMode"] = "GLOW"; },
         "material 0: alphaMode \"GLOW\"", true},
        {"CameraFov",
         [](GltfBuilder& b) {
             b.json["cameras"] = Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 1}}}}});
         },
         "camera 0 perspective: yfov 4", true},
        {"CameraFar",
         [](GltfBuilder& b) {
             b.json["cameras"] =
                 Json::array({{{"type", "orthographic"}, {"orthographic", {{"ymag", 1}, {"znear", 5}, {"zfar", 5}}}}});
         },
         "camera 0 orthographic: zfar 5 is not beyond znear 5", true},
        {"LightCone",
         [](GltfBuilder& b) {
             b.json["extensions"]["KHR_lights_punctual"]["lights"] =
                 Json::array({{{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.5}}}}});
         },
         "light 0 spot: innerConeAngle 0.5 is not below outerConeAngle 0.5", true},
        {"LightType",
         [](GltfBuilder& b) {
             b.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({{{"type", "sun"}}});
         },
         "light 0: type \"sun\"", true},
        {"LightMissing", [](GltfBuilder& b) { b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0; },
         "node 0 KHR_lights_punctual: light is 0, but there are 0"},
    };
}

INSTANTIATE_TEST_SUITE_P(Kinds, GltfErrors, testing::ValuesIn(damaged_files()),
                         [](const auto& bad) { return std::string(bad.param.name); });

TEST(GltfContainer, TruncatedAtEveryLength) {
    const Bytes whole = GltfBuilder::textured_triangle().glb();
    ASSERT_EQ(error_of(whole), "");
    for (size_t length = 0; length < whole.size(); ++length)
        ASSERT_THAT(error_of(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length))), StartsWith("test.glb: "))
            << length;
    EXPECT_THAT(error_of(Bytes(whole.begin(), whole.begin() + 100)),
                StartsWith("test.glb: header: the file is truncated: 100 of "));
}

TEST(GltfContainer, ChunkLongerThanTheFile) {
    Bytes bytes = GltfBuilder::triangle().glb();
    bytes[14] = 0xff;
    EXPECT_THAT(error_of(bytes), StartsWith("test.glb: chunk 0: its length "));
    bytes = GltfBuilder::triangle().glb();
    bytes[16] = 'X';
    EXPECT_EQ(error_of(bytes), "test.glb: chunk 0: is not JSON");
    bytes[4] = 1;
    EXPECT_EQ(error_of(bytes), "test.glb: header: the file is binary glTF 1.0; only glTF 2.0 is read");
}

TEST(GltfContainer, EveryByteChangedInTurn) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(png(2, 2, solid(2, 2, {9, 9, 9, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["normalTexture"]["index"] = 0;
    const Bytes whole = b.glb();
    size_t errors = 0;
    for (size_t i = 0; i < whole.size(); ++i)
        for (const uint8_t flip : {0xff, 0x20, 0x01}) {
            Bytes damaged = whole;
            damaged[i] ^= flip;
            // An error, a warning or a scene, and no crash.
            errors += !error_of(damaged).empty() || !load_bytes(damaged).warnings.empty();
        }
    EXPECT_GT(errors, whole.size());
}

TEST(GltfContainer, TextFormWithBase64AndByteOrderMark) {
    Bytes bytes = GltfBuilder::triangle().gltf();
    EXPECT_EQ(error_of(bytes), "");
    bytes.insert(bytes.begin(), {0xef, 0xbb, 0xbf});
    EXPECT_EQ(error_of(bytes), "");
}

TEST(GltfContainer, TextsThatAreNoScene) {
    const std::string none = "test.glb: file: is no glTF file: it is neither GLB nor a JSON object";
    EXPECT_EQ(error_of_text(""), "test.glb: file: is empty");
    for (const char* text : {"not JSON", "[]", "  \n", "\x89PNG\r\n\x1a\n", "v 0 0 0\nf 1 1 1\n", "\xef\xbb\xbf<xml/>"})
        EXPECT_EQ(error_of_text(text), none) << text;
    EXPECT_EQ(error_of_text("{}"), "test.glb: asset: is missing: the file's JSON is no glTF 2.0");
    EXPECT_EQ(error_of_text("{\"asset\":{\"version\":\"2.0\"},\"asset\":{\"version\":\"2.0\"}}"),
              ""); // a key that stands twice
}

TEST(GltfContainer, BrokenJsonSaysWhereItBreaks) {
    const auto broken = [](const std::string& place) {
        return "test.glb: JSON: is damaged: what stands at " + place + " does not belong there";
    };
    EXPECT_EQ(error_of_text("{\"asset\":{\"version\":\"2.0\"},\n \"x\": nope}"), broken("line 2, column 8"));
    EXPECT_THAT(error_of_text("{\"asset\":{\"version\":\"2.0\"},\"x\":1e999}"),
                StartsWith("test.glb: JSON: is damaged"));
    EXPECT_THAT(error_of_text("{\"asset\":"), StartsWith("test.glb: JSON: is damaged"));
    EXPECT_EQ(error_of_text("{\"name\":\"\xff\"}"), "test.glb: JSON: is not UTF-8");
}

TEST(GltfContainer, OlderVersionsAreNamed) {
    const std::string old = "test.glb: asset: ";
    EXPECT_EQ(error_of_text(R"({"asset":{"version":"1.0"},"nodes":{"a":{}}})"),
              old + "the file is glTF 1.0; only glTF 2.0 is read");
    EXPECT_EQ(error_of_text(R"({"asset":{"version":"1.1"}})"), old + "the file is glTF 1.1; only glTF 2.0 is read");
    EXPECT_EQ(error_of_text(R"({"asset":{"version":1.0},"nodes":{}})"),
              old + "the file is glTF 1.0; only glTF 2.0 is read");
    EXPECT_EQ(error_of_text(R"({"asset":{"version":"3.0"}})"), old + "the file is glTF 3.0; only glTF 2.0 is read");
    EXPECT_EQ(error_of_text(R"({"nodes":{"a":{}}})"),
              old + "is missing, and tables are objects: the file is glTF 1.0 or older; only glTF 2.0 is read");
    EXPECT_EQ(error_of_text(R"({"asset":{"generator":"x"},"meshes":{}})"),
              old + "has no version, and tables are objects: the file is glTF 1.0 or older; only glTF 2.0 is read");
    EXPECT_EQ(error_of_text(R"({"asset":{"version":2.0}})"), "") << "a number instead of a string";
}

TEST(GltfContainer, FilesThatCannotBeRead) {
    const TemporaryFolder folder;
    const auto line = [](const std::filesystem::path& path) {
        try {
            load_gltf(path);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(line(folder.path / "none.glb"),
              (folder.path / "none.glb").string() + ": file: cannot be opened (No such file or directory)");
    EXPECT_THAT(line(folder.path), HasSubstr(": file: is a folder, not a file"));
    EXPECT_THAT(line("/dev/zero"), HasSubstr("/dev/zero: file: is a device, not a file"));
    const std::filesystem::path good = folder.write("good.glb", GltfBuilder::triangle().glb());
    EXPECT_EQ(line(good), "");
    try {
        load_gltf(good, {.memory_limit = 1024});
        ADD_FAILURE() << "a quarter of that is for files";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("file: needs more memory than the memory limit allows"));
    }
}

} // namespace
