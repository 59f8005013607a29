#include "pictures.hpp"
#include <algorithm>
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <scene/gltf/budget.hpp>
#include <scene/gltf/load.hpp>
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
    EXPECT_EQ(error_of_text(objects + "1" + std::string(400'001, '}')), "test.glb: JSON: is nested deeper than 128");
    EXPECT_EQ(error_of_text(head + std::string(100, '[') + std::string(100, ']') + "}"), "");
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
        const size_t taken = memory_growth([&] { EXPECT_EQ(error_of_text(text), ""); });
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
            EXPECT_LT(taken, gltf::Budget::geometry_constant + gltf::Budget::multiple * text.size()) << table;
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
        EXPECT_LT(taken_by("count", 100'000'000u), size_t(8) << 20);
    }
}

std::string picture_error(const Bytes& picture, const LoadOptions& options = {}) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(picture);
    b.json["textures"] = Json::array({{{"source", 0}}});
    b.json["materials"][0]["emissiveTexture"]["index"] = 0;
    LoadOptions strict = options;
    strict.strict = true;
    try {
        gltf::load(b.glb(), "test.glb", "/", strict);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

/// Says it is that large, and has data for one texel.
Bytes png_of_size(uint32_t width, uint32_t height) {
    return RawPng{.width = width, .height = height, .lines = Bytes(5)}.bytes();
}

TEST(GltfLimits, HeadersThatLieTakeNoMemory) {
    const auto refused = [](const Bytes& picture, const char* why) {
        std::string line;
        const size_t taken = memory_growth([&] { line = picture_error(picture); });
        EXPECT_THAT(line, HasSubstr(why));
        if (!sanitized) {
            EXPECT_LT(taken, size_t(8) << 20);
        }
    };
    refused(png_of_size(100'000, 100'000), "image 0: 100000 × 100000 pixels are beyond the limit");
    refused(png_of_size(200'000, 1), "beyond the limit");
    refused(png_of_size(0x7fffffff, 0x7fffffff), "beyond the limit");
    refused(png_of_size(32'768, 32'768), "too short for its size");
    refused(png_of_size(8'192, 8'192), "too short for its size");
    Bytes huge = jpeg(16, 16, solid(16, 16, {200, 100, 50, 255}));
    const Bytes marker{0xff, 0xc0};
    const auto frame = std::search(huge.begin(), huge.end(), marker.begin(), marker.end());
    ASSERT_NE(frame, huge.end());
    std::fill(frame + 5, frame + 9, uint8_t(0xff)); // 65,535 a side, libjpeg's limit is 65,500
    refused(huge, "image 0: does not decode");
    frame[5] = frame[7] = 0x40;
    refused(huge, "too short for its size");
}

TEST(GltfLimits, PngChunkWithANewlineInItsName) {
    Bytes bytes = png(1, 1, solid(1, 1, {1, 2, 3, 4}));
    const Bytes name = {'A', '\n', 0xff, 'A'};
    std::copy(name.begin(), name.end(), bytes.begin() + 37); // where IDAT stands
    EXPECT_EQ(picture_error(bytes), "test.glb: image 0: does not decode (PNG: it has a chunk of an unknown kind that "
                                    "matters); what shows it is plain");
}

TEST(GltfLimits, PngThatUnpacksToMoreThanItsPicture) {
    // 12 MB of zeros in 12 kB; the header says that the picture is 1 × 1.
    const Bytes bytes = RawPng{.lines = Bytes(12'000'000)}.bytes();
    ASSERT_LT(bytes.size(), 20'000u);
    std::string line;
    const size_t taken = memory_growth([&] { line = picture_error(bytes); });
    EXPECT_EQ(line, ""); // what it has beyond that is not looked at
    if (!sanitized) {
        EXPECT_LT(taken, size_t(6) << 20);
    }
}

TEST(GltfLimits, WebpWithAHugeHeader) {
    Bytes bytes = webp_lossless(1, 1, {1, 2, 3, 4});
    // VP8L: signature 0x2f at 20, then width − 1 and height − 1 in 14 bits each.
    ASSERT_EQ(bytes[20], 0x2f);
    bytes[21] = 0xff, bytes[22] = 0xff, bytes[23] = 0xff, bytes[24] |= 0x0f;
    EXPECT_NE(picture_error(bytes, {.memory_limit = uint64_t(2) << 30}), "");
}

TEST(GltfLimits, JpegWithManyScansAndWithoutItsEnd) {
    const Bytes grey(64, 77);
    Bytes bytes = jpeg_of(8, 8, grey, {.stored = JpegForm::Stored::grey, .progressive = true});
    ASSERT_EQ(picture_error(bytes), "");
    Bytes cut(bytes.begin(), bytes.end() - 2);
    EXPECT_THAT(picture_error(cut), HasSubstr("JPEG: Premature end of JPEG file"));
    // The scan that refines the DC coefficient's last bit, again and again: each is two bytes of data at most.
    const Bytes scan{0xff, 0xda, 0, 8, 1, 1, 0, 0, 0, 0x10, 0x7f};
    for (int i = 0; i < 200; ++i)
        bytes.insert(bytes.end() - 2, scan.begin(), scan.end());
    EXPECT_THAT(picture_error(bytes), HasSubstr("more than 100 scans"));
}

TEST(GltfLimits, JpegWithAHuffmanTableThatIsTooLong) {
    // Found by fuzzing: another decoder wrote the 272 values past its table of 256.
    Bytes bytes = jpeg(16, 16, solid(16, 16, {200, 100, 50, 255}));
    Bytes table = {0xff, 0xc4, 0x01, 0x23, 0x00};
    table.insert(table.end(), 16, 17);
    table.insert(table.end(), 272, 1);
    bytes.insert(bytes.begin() + 2, table.begin(), table.end());
    EXPECT_THAT(picture_error(bytes), HasSubstr("image 0: does not decode (JPEG: Bogus Huffman table definition)"));
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
    const size_t taken = memory_growth([&] { EXPECT_EQ(load_bytes(bytes).meshes[0].primitives.size(), 2'000u); });
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
    EXPECT_THAT(error_of(b), HasSubstr("more pixels in all than a file of this size may have"));
}

/// Grey lines of one value each: `side` × `side` texels that pack to a thousandth.
Bytes flat_png(uint32_t side, uint8_t value) {
    RawPng png{.width = side, .height = side, .colour = 0};
    for (uint32_t y = 0; y < side; ++y) {
        png.lines.push_back(0);
        png.lines.insert(png.lines.end(), side, value);
    }
    return png.bytes();
}

/// A material for each picture.
GltfBuilder with_pictures(const std::vector<Bytes>& pictures, const char* texture = "emissiveTexture") {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.json["materials"] = Json::array();
    for (size_t i = 0; i < pictures.size(); ++i) {
        b.add_image(pictures[i]);
        b.json["textures"].push_back({{"source", i}});
        b.json["materials"].push_back({{texture, {{"index", i}}}});
    }
    return b;
}

Scene load_with(const GltfBuilder& b, uint64_t memory_limit) {
    return gltf::load(b.glb(), "test.glb", "/", {.memory_limit = memory_limit});
}

TEST(GltfPictureBudget, ValidTexturesOpenWhateverTheyUnpackTo) {
    // 8192 × 8192 texels in 84 kB.
    const Bytes large = flat_png(8192, 200);
    ASSERT_LT(large.size(), 100'000u);
    const GltfBuilder b = with_pictures({large});
    Scene scene = load_with(b, uint64_t(2) << 30);
    EXPECT_EQ(scene.images.at(0).width, 8192u);
    EXPECT_EQ(scene.images.at(0).rgba.at(4 * (8192 * 5000 + 77)), 200);
    EXPECT_TRUE(scene.warnings.empty());
    // A quarter of the memory, a quarter of the texels.
    size_t taken = memory_growth([&] { scene = load_with(b, uint64_t(512) << 20); });
    EXPECT_EQ(scene.images.at(0).width, 4096u);
    EXPECT_EQ(scene.images.at(0).rgba.at(77), 200 + 55 * (77 % 4 == 3));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "test.glb: image 0: scaled down from 8192 × 8192 to 4096 × 4096 pixels: pictures may "
                                 "take 128 MiB (a quarter of the memory limit)");
    if (!sanitized) {
        EXPECT_LT(taken, size_t(160) << 20);
    }
}

TEST(GltfPictureBudget, TheLargestOnesAreScaledDown) {
    std::vector<Bytes> pictures{flat_png(64, 10)};
    for (int i = 0; i < 12; ++i)
        pictures.push_back(flat_png(1024, uint8_t(20 + i)));
    const GltfBuilder b = with_pictures(pictures);
    EXPECT_TRUE(load_with(b, uint64_t(256) << 20).warnings.empty()); // 48 MiB of 64
    // 16 MiB: some stay as they are. The small one does in any case.
    const Scene scene = load_with(b, uint64_t(64) << 20);
    uint64_t bytes = 0;
    for (size_t i = 0; i < scene.images.size(); ++i) {
        const TextureImage& image = scene.images[i];
        bytes += image.rgba.size();
        EXPECT_TRUE(image.width == 64 || image.width == 512 || image.width == 1024) << image.width;
        EXPECT_EQ(image.rgba.at(0), i == 0 ? 10 : 19 + i);
        EXPECT_EQ(image.rgba.size(), size_t(image.width) * image.height * 4);
    }
    EXPECT_EQ(scene.images[0].width, 64u);
    EXPECT_LE(bytes, uint64_t(16) << 20);
    EXPECT_GT(bytes, uint64_t(8) << 20);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_THAT(scene.warnings[0], HasSubstr(": scaled down from 1024 × 1024 to 512 × 512 pixels"));
    EXPECT_THAT(scene.warnings[0], HasSubstr("in all)"));
    EXPECT_THAT(load_with(with_pictures({flat_png(1024, 7)}), uint64_t(6) << 20).warnings.at(0),
                HasSubstr("to 256 × 256"));
}

TEST(GltfPictureBudget, EachKindIsAveragedAsItMeans) {
    // Columns of two values in turn; 1024 × 1024 texels shrink to 512 × 512.
    Bytes stripes;
    for (int i = 0; i < 1024 * 1024; ++i)
        stripes.insert(stripes.end(), {uint8_t(i % 2 ? 218 : 37), 128, 218, 255});
    const auto texel = [&](const char* texture) {
        const Scene scene = load_with(with_pictures({png(1024, 1024, stripes)}, texture), uint64_t(16) << 20);
        EXPECT_EQ(scene.images.at(0).width, 512u);
        return scene.images[0].rgba.at(0);
    };
    EXPECT_NEAR(texel("normalTexture"), 128, 1);
    EXPECT_NEAR(texel("occlusionTexture"), 128, 1); // (218 + 37) / 2
    EXPECT_NEAR(texel("emissiveTexture"), 163, 1);  // the mean of the light of codes 218 and 37
}

TEST(GltfPictureBudget, OneThatNeverFitsCostsNoOtherItsTexels) {
    // Lossless WebP and progressive JPEG are decoded whole: no scaling helps.
    GltfBuilder b = with_pictures({flat_png(256, 9), webp_lossless(1024, 1024, Bytes(1024 * 1024 * 4, 7))});
    try {
        load_with(b, uint64_t(32) << 20);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("image 1: needs more memory than the memory limit allows"));
    }
    EXPECT_EQ(load_with(b, uint64_t(256) << 20).images.at(1).width, 1024u);
}

TEST(GltfPictureBudget, NamesAreTold) {
    GltfBuilder b = with_pictures({flat_png(1024, 7)});
    b.json["images"][0]["name"] = "roof\n";
    EXPECT_THAT(load_with(b, uint64_t(8) << 20).warnings.at(0), HasSubstr("image 0 (roof\\n): scaled down"));
}

TEST(GltfPictureBudget, BombsTakeNoMoreMemoryThanTheirShare) {
    // Five of 67 million texels each: 1.3 GB.
    const GltfBuilder b = with_pictures(std::vector<Bytes>(5, flat_png(8192, 1)));
    const size_t taken = memory_growth([&] { EXPECT_EQ(load_with(b, uint64_t(256) << 20).images.size(), 5u); });
    if (!sanitized) {
        EXPECT_LT(taken, size_t(96) << 20);
    }
}

TEST(GltfBudget, CountsAndRefuses) {
    gltf::Budget budget(uint64_t(1) << 40);
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
    EXPECT_EQ(budget.limit(Pool::images), uint64_t(1) << 38);
    budget.charge_work(gltf::Budget::work_constant + gltf::Budget::work_multiple);
    EXPECT_THROW(budget.charge_work(1), gltf::Budget::Exceeded);
    EXPECT_THROW(budget.charge_work(~uint64_t(0)), gltf::Budget::Exceeded);
    // A machine that can spare little.
    gltf::Budget small(1 << 20);
    small.add_input(1 << 20);
    EXPECT_EQ(small.limit(Pool::geometry), uint64_t(1) << 18);
    EXPECT_EQ(small.room_for_input(), 0u);
}

} // namespace
