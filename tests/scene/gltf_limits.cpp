#include "gltf_builder.hpp"
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scene/gltf/budget.hpp>
#include <string_view>

using namespace prelight;
using namespace prelight::test;
using testing::HasSubstr;

namespace {

const std::string head = R"({"asset":{"version":"2.0"},"extras":)";

TEST(GltfLimits, NestedExtrasAreRefused) {
    const std::string text = head + std::string(400'000, '[') + std::string(400'000, ']') + "}";
    EXPECT_EQ(error_of_text(text), "test.glb: JSON: is nested deeper than 128");
    std::string objects = head;
    for (int i = 0; i < 400'000; ++i)
        objects += "{\"a\":";
    EXPECT_EQ(error_of_text(objects + "1" + std::string(400'001, '}')),
              "test.glb: JSON: is nested deeper than 128");
    EXPECT_EQ(error_of_text(head + std::string(100, '[') + std::string(100, ']') + "}"),
              "");
}

TEST(GltfLimits, TwentyMegabytesOfExtrasTakeAFewTimesTheirSize) {
    constexpr size_t size = 20'000'000;
    for (const std::string_view unit : {"0,", "{},", "\"ab\",", "{\"a\":[1.5,{}]},"}) {
        std::string text = head + "[";
        text.reserve(size + 64);
        while (text.size() < size)
            text += unit;
        text.back() = ']';
        text += '}';
        const auto start = std::chrono::steady_clock::now();
        const size_t taken = memory_growth(
            [&] { EXPECT_EQ(error_of_text(text), ""); });
        if (!sanitized) {
            EXPECT_LT(taken, 20 * size) << unit;
        }
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    }
}

TEST(GltfLimits, MillionsOfEmptyObjectsStayBelowTheMultiple) {
    // 3 bytes each, and each a node, a material, a mesh …
    for (const char* table : {"nodes", "materials", "meshes", "accessors", "textures", "scenes"}) {
        std::string text = std::string(R"({"asset":{"version":"2.0"},")") + table + "\":[";
        for (int i = 0; i < 500'000; ++i)
            text += "{},";
        text.back() = ']';
        text += '}';
        const size_t taken = memory_growth([&] { error_of_text(text); });
        if (!sanitized) {
            EXPECT_LT(taken, gltf::Budget::geometry_constant + gltf::Budget::multiple * text.size())
                << table;
        }
    }
}

TEST(GltfLimits, CountsThatLieAllocateNothing) {
    const auto taken_by = [](const char* what, const Json& value) {
        GltfBuilder b = GltfBuilder::triangle();
        b.json["accessors"][0].erase("bufferView");
        b.json["accessors"][0][what] = value;
        std::string line;
        const size_t taken = memory_growth([&] { line = error_of(b); });
        EXPECT_THAT(line, HasSubstr("needs more memory"));
        return taken;
    };
    if (!sanitized) {
        EXPECT_LT(taken_by("count", 4'000'000'000u), size_t(8) << 20);
        EXPECT_LT(taken_by("count", 20'000'000u), size_t(8) << 20);
    }
}

/// Big-endian word into a PNG's bytes.
void put(Bytes& bytes, size_t at, uint32_t value) {
    for (int i = 0; i < 4; ++i)
        bytes[at + size_t(i)] = uint8_t(value >> (24 - 8 * i));
}

std::string picture_error(const Bytes& picture) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(picture);
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["emissiveTexture"]["index"] = 0;
    return strict_error_of(b);
}

TEST(GltfLimits, PicturesBeyondTheLimitOfPixels) {
    Bytes bytes = png(1, 1, solid(1, 1, {1, 2, 3, 4}));
    put(bytes, 16, 20'000);
    EXPECT_THAT(picture_error(bytes), HasSubstr("image 0: 20000 × 1 pixels are beyond the limit"));
    put(bytes, 16, 16'384);
    put(bytes, 20, 16'384);
    EXPECT_THAT(picture_error(bytes), HasSubstr("beyond the limit"));
    put(bytes, 20, 4'096); // within the limit of pixels, but not of a file of 100 bytes
    EXPECT_THAT(picture_error(bytes), HasSubstr("image 0: needs more memory"));
}

TEST(GltfLimits, PngChunkWithANewlineInItsName) {
    // Found by fuzzing: stb_image's reason quotes the name.
    Bytes bytes = png(1, 1, solid(1, 1, {1, 2, 3, 4}));
    const Bytes name = {'A', '\n', 0xff, 'A'};
    std::copy(name.begin(), name.end(), bytes.begin() + 37); // where IDAT stands
    EXPECT_EQ(picture_error(bytes),
              "test.glb: image 0: does not decode (A??A PNG chunk not known); what shows it is plain");
}

TEST(GltfLimits, PngThatUnpacksToMoreThanItsPicture) {
    // 12 MB of zeros in 12 kB; the header then says that the picture is 1 × 1.
    Bytes bytes = png(1024, 3000, Bytes(size_t(1024) * 3000 * 4));
    ASSERT_LT(bytes.size(), 1'000'000u);
    put(bytes, 16, 1);
    put(bytes, 20, 1);
    std::string line;
    const size_t taken = memory_growth([&] { line = picture_error(bytes); });
    EXPECT_THAT(line, HasSubstr("image 0: does not decode"));
    if (!sanitized) {
        EXPECT_LT(taken, size_t(6) << 20);
    }
}

TEST(GltfLimits, WebpWithAHugeHeader) {
    Bytes bytes = webp_lossless(1, 1, {1, 2, 3, 4});
    // VP8L: signature 0x2f at 20, then width − 1 and height − 1 in 14 bits each.
    ASSERT_EQ(bytes[20], 0x2f);
    bytes[21] = 0xff, bytes[22] = 0xff, bytes[23] = 0xff, bytes[24] |= 0x0f;
    EXPECT_THAT(picture_error(bytes), HasSubstr("16384 × 16384 pixels are beyond the limit"));
}

TEST(GltfLimits, JpegWithManyScansAndWithoutItsEnd) {
    Bytes bytes = jpeg(16, 16, solid(16, 16, {200, 100, 50, 255}));
    ASSERT_EQ(picture_error(bytes), "");
    Bytes cut(bytes.begin(), bytes.end() - 2);
    EXPECT_THAT(picture_error(cut), HasSubstr("JPEG is truncated"));
    for (int i = 0; i < 200; ++i)
        bytes.insert(bytes.end() - 2, {0xff, 0xda, 0, 2});
    EXPECT_THAT(picture_error(bytes), HasSubstr("more than 100 scans"));
}

TEST(GltfLimits, JpegWithAHuffmanTableThatIsTooLong) {
    // Found by fuzzing: stb_image 2.27 writes the 272 values past its table of 256.
    Bytes bytes = jpeg(16, 16, solid(16, 16, {200, 100, 50, 255}));
    Bytes table = {0xff, 0xc4, 0x01, 0x23, 0x00};
    table.insert(table.end(), 16, 17);
    table.insert(table.end(), 272, 1);
    bytes.insert(bytes.begin() + 2, table.begin(), table.end());
    EXPECT_THAT(picture_error(bytes),
                HasSubstr("image 0: does not decode (JPEG: bad Huffman table)"));
}

TEST(GltfLimits, ManyPrimitivesOverOneLargeBufferStaySmallAndFast) {
    // A reader that copies all vertices for each primitive would take 2,000 × 2.4 MB here.
    GltfBuilder b = GltfBuilder::triangle();
    b.attributes()["POSITION"] = b.add_floats(std::vector<float>(600'000, 1), "VEC3");
    b.attributes()["NORMAL"] = b.attributes()["POSITION"];
    b.primitive()["indices"] = b.add_values<uint32_t>({0, 100'000, 199'999}, 5125, "SCALAR");
    const Json primitive = b.primitive();
    for (int i = 1; i < 2'000; ++i)
        b.json["meshes"][0]["primitives"].push_back(primitive);
    const Bytes bytes = b.glb();
    const size_t taken =
        memory_growth([&] { EXPECT_EQ(load_bytes(bytes).meshes[0].primitives.size(), 2'000u); });
    if (!sanitized) {
        EXPECT_LT(taken, size_t(64) << 20);
    }
}

TEST(GltfLimits, OneLargeAccessorForManyPrimitivesMeetsTheBudget) {
    GltfBuilder b = GltfBuilder::triangle();
    b.attributes()["POSITION"] = b.add_floats(std::vector<float>(300'000, 1), "VEC3");
    const Json primitive = b.primitive();
    for (int i = 1; i < 5'000; ++i) // without indices: 5,000 × 100,000 vertices
        b.json["meshes"][0]["primitives"].push_back(primitive);
    EXPECT_THAT(error_of(b), HasSubstr("needs more memory"));
}

TEST(GltfLimits, AChainOfNodesAsDeepAsTheFileIsLong) {
    std::string text = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)";
    constexpr int count = 300'000;
    for (int i = 1; i < count; ++i)
        text += "{\"children\":[" + std::to_string(i) + "]},";
    text += "{}]}";
    EXPECT_EQ(error_of_text(text), "");
}

TEST(GltfLimits, ManyScenesOfManyNodesAreReadInLinearTime) {
    std::string text = R"({"asset":{"version":"2.0"},"scenes":[{})";
    for (int i = 1; i < 300'000; ++i)
        text += ",{}";
    text += "],\"nodes\":[{}";
    for (int i = 1; i < 300'000; ++i)
        text += ",{}";
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(error_of_text(text + "]}"), "");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(GltfLimits, ManyImagesOfTheSameBytesMeetTheBudget) {
    Bytes picture = jpeg(1, 1, solid(1, 1, {9, 9, 9, 255}));
    const Bytes comment = {0xff, 0xfe, 0xff, 0xff};
    for (int i = 0; i < 160; ++i) { // 10 MB that decoding has to walk over
        picture.insert(picture.begin() + 2, 0xfffd, 0);
        picture.insert(picture.begin() + 2, comment.begin(), comment.end());
    }
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(picture);
    const Json image = b.json["images"][0];
    for (int i = 0; i < 1'000; ++i) {
        b.json["images"].push_back(image);
        b.json["textures"].push_back({{"source", i}});
        b.json["materials"].push_back({{"emissiveTexture", {{"index", i}}}});
    }
    EXPECT_THAT(error_of(b), HasSubstr("needs more memory"));
}

TEST(GltfBudget, CountsAndRefuses) {
    gltf::Budget budget;
    using Pool = gltf::Budget::Pool;
    EXPECT_EQ(budget.left(Pool::geometry), gltf::Budget::geometry_constant);
    EXPECT_THROW(budget.charge(Pool::geometry, ~uint64_t(0), ~uint64_t(0)), gltf::Budget::Exceeded);
    EXPECT_THROW(budget.charge(Pool::geometry, uint64_t(1) << 33, uint64_t(1) << 31),
                 gltf::Budget::Exceeded); // the product is 0 in 64 bits
    budget.charge(Pool::geometry, gltf::Budget::geometry_constant);
    EXPECT_THROW(budget.charge(Pool::geometry, 1), gltf::Budget::Exceeded);
    budget.add_input(1);
    budget.charge(Pool::geometry, gltf::Budget::multiple);
    EXPECT_EQ(budget.left(Pool::geometry), 0u);
    {
        const gltf::Loan loan(budget, Pool::images, 1000);
        EXPECT_EQ(budget.left(Pool::images), budget.limit(Pool::images) - 1000);
    }
    EXPECT_EQ(budget.left(Pool::images), budget.limit(Pool::images));
}

} // namespace
