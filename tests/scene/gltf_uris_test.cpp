#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>

using namespace prelight;
using namespace prelight::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// A scene whose buffer is a file of its own, in "inner/" of a folder with a copy beside it.
class GltfUris : public testing::Test {
protected:
    GltfUris() {
        builder_ = GltfBuilder::triangle();
        for (const char* name : {"secret.bin", "inner/data.bin", "inner/sub/data.bin", "inner/a b.bin"})
            folder_.write(name, builder_.binary);
    }

    std::string error_with(const std::string& uri) {
        builder_.json["buffers"][0]["uri"] = uri;
        const std::string text = builder_.json.dump();
        const auto path = folder_.write("inner/scene.gltf", Bytes(text.begin(), text.end()));
        try {
            load_gltf(path);
        } catch (const Error& error) {
            const std::string line = error.what();
            EXPECT_EQ(line.find(path.string() + ": buffer 0: "), 0u) << line;
            return line;
        }
        return {};
    }

    TemporaryFolder folder_;
    GltfBuilder builder_;
};

TEST_F(GltfUris, FilesBesideTheScene) {
    for (const char* uri :
         {"data.bin", "./data.bin", "sub/data.bin", "sub/../data.bin", "a%20b.bin", "a b.bin", "%64ata.bin"})
        EXPECT_EQ(error_with(uri), "") << uri;
}

TEST_F(GltfUris, NothingOutsideTheFolder) {
    const std::string absolute = (folder_.path / "secret.bin").string();
    for (const std::string& uri :
         {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"), std::string("..%2fsecret.bin"),
          std::string("sub/../../secret.bin"), std::string("../inner/data.bin"), absolute, "/" + absolute,
          std::string("%2fetc/hostname")})
        EXPECT_THAT(error_with(uri), HasSubstr("its URI leads outside the scene's folder")) << uri;
}

TEST_F(GltfUris, NoSchemesButData) {
    for (const char* uri : {"file:data.bin", "file:///etc/hostname", "http://example.org/data.bin",
                            "HTTPS://example.org/x", "c:\\data.bin"})
        EXPECT_THAT(error_with(uri), HasSubstr("has a scheme")) << uri;
}

TEST_F(GltfUris, SymbolicLinksAreFollowedBeforeTheCheck) {
    std::filesystem::create_symlink("../secret.bin", folder_.path / "inner/link.bin");
    std::filesystem::create_directory_symlink("..", folder_.path / "inner/up");
    std::filesystem::create_symlink("data.bin", folder_.path / "inner/fine.bin");
    std::filesystem::create_symlink("loop.bin", folder_.path / "inner/loop.bin");
    EXPECT_THAT(error_with("link.bin"), HasSubstr("leads outside"));
    EXPECT_THAT(error_with("up/secret.bin"), HasSubstr("leads outside"));
    EXPECT_EQ(error_with("fine.bin"), "");
    EXPECT_THAT(error_with("loop.bin"), HasSubstr("cannot be read"));
}

TEST_F(GltfUris, OddUris) {
    EXPECT_THAT(error_with(""), HasSubstr("is empty"));
    EXPECT_THAT(error_with("none.bin"), HasSubstr("buffer 0: \"none.bin\" cannot be read: No such file"));
    EXPECT_THAT(error_with("sub/../no%20ne.bin"), HasSubstr("buffer 0: \"sub/../no%20ne.bin\" cannot be read"))
        << "as the file names it";
    EXPECT_THAT(error_with("sub"), HasSubstr("does not name a file"));
    EXPECT_THAT(error_with("."), HasSubstr("leads outside")); // the folder itself
    EXPECT_THAT(error_with("%zz.bin"), HasSubstr("bad percent code"));
    EXPECT_THAT(error_with("data.bin%00"), HasSubstr("zero byte"));
    EXPECT_THAT(error_with("data.bin%"), HasSubstr("bad percent code"));
    EXPECT_THAT(error_with(std::string(5000, 'a')), HasSubstr("longer than 4096"));
}

TEST_F(GltfUris, DataUris) {
    const std::string start = "data:application/octet-stream;base64,";
    EXPECT_EQ(error_with(start + base64(builder_.binary)), "");
    EXPECT_THAT(error_with("data:text/plain,abc"), HasSubstr("not base64"));
    EXPECT_THAT(error_with(start + "AA$A"), HasSubstr("not base64"));
    EXPECT_THAT(error_with(start + "AAAAA"), HasSubstr("cut short"));
    EXPECT_THAT(error_with(start + "AAAA"), HasSubstr("byteLength is 36, but there are 3 bytes"));
}

TEST_F(GltfUris, PicturesFollowTheSameRules) {
    builder_ = GltfBuilder::textured_triangle();
    folder_.write("inner/data.bin", builder_.binary);
    folder_.write("outside.png", png(1, 1, solid(1, 1, {1, 2, 3, 255})));
    folder_.write("inner/inside.png", png(1, 1, solid(1, 1, {1, 2, 3, 255})));
    builder_.json["textures"] = Json::array({{{"source", 0}}});
    builder_.json["materials"][0]["emissiveTexture"]["index"] = 0;
    builder_.json["images"] = Json::array({{{"uri", "inside.png"}}});
    EXPECT_EQ(error_with("data.bin"), "");
    builder_.json["buffers"][0]["uri"] = "data.bin";
    builder_.json["images"][0]["uri"] = "../outside.png";
    const std::string text = builder_.json.dump();
    const auto path = folder_.write("inner/scene.gltf", Bytes(text.begin(), text.end()));
    const Scene scene = load_gltf(path);
    EXPECT_FALSE(scene.materials[0].emissive_texture);
    EXPECT_THAT(scene.warnings,
                ElementsAre(HasSubstr("image 0: its URI leads outside the scene's folder: \"../outside.png\"")));
}

TEST_F(GltfUris, ThatAreNoPercentCodesOrOnDiskAsWritten) {
    folder_.write("inner/example 10%.bin", builder_.binary);
    folder_.write("inner/100%zz.bin", builder_.binary);
    folder_.write("inner/big%20ball.bin", builder_.binary);
    const auto warning_of = [&](const std::string& uri) {
        EXPECT_EQ(error_with(uri), "") << uri;
        const Scene scene = load_gltf(folder_.path / "inner/scene.gltf");
        return scene.warnings.empty() ? std::string() : scene.warnings[0];
    };
    EXPECT_THAT(warning_of("example 10%.bin"),
                HasSubstr("buffer 0: its URI has a bad percent code; it is taken as it is written"));
    EXPECT_THAT(warning_of("100%zz.bin"), HasSubstr("bad percent code"));
    EXPECT_THAT(warning_of("big%20ball.bin"), HasSubstr("buffer 0: its URI names a file only as it is written"));
    EXPECT_THAT(warning_of("sub\\data.bin"), HasSubstr("backslashes"));
    EXPECT_THAT(warning_of("sub%5Cdata.bin"), HasSubstr("backslashes"));
    folder_.write("inner/big ball.bin", builder_.binary);
    EXPECT_EQ(warning_of("big%20ball.bin"), "") << "the decoded name comes first";
    EXPECT_NO_THROW(load_gltf(folder_.path / "inner/scene.gltf", {.strict = true}));
    EXPECT_THAT(error_with("..%2fsecret.bin%"), HasSubstr("bad percent code"));
    EXPECT_THAT(error_with("..\\secret.bin"), HasSubstr("leads outside"));
}

TEST_F(GltfUris, PicturesThatAreNotThereLeaveTheMaterialPlain) {
    builder_ = GltfBuilder::textured_triangle();
    builder_.json["textures"] = Json::array({{{"source", 0}}, {{"source", 1}}});
    builder_.json["materials"][0] = {
        {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 1}}, {"baseColorTexture", {{"index", 0}}}}},
        {"normalTexture", {{"index", 1}}},
        {"emissiveTexture", {{"index", 0}}}};
    builder_.json["images"] = Json::array({{{"uri", "not there.png"}}, {{"uri", "data.bin"}}});
    folder_.write("inner/data.bin", builder_.binary);
    EXPECT_EQ(error_with("data.bin"), "");
    const Scene scene = load_gltf(folder_.path / "inner/scene.gltf");
    const Material& m = scene.materials[0];
    EXPECT_FALSE(m.base_colour_texture || m.normal_texture || m.emissive_texture);
    EXPECT_EQ(m.base_colour, glm::vec4(0.5f, 0.25f, 1, 1));
    EXPECT_THAT(
        scene.warnings,
        ElementsAre(
            HasSubstr("image 0: \"not there.png\" cannot be read: No such file or directory; what shows it is plain"),
            HasSubstr("image 1: is neither PNG, JPEG nor WebP; what shows it is plain")));
}

} // namespace
