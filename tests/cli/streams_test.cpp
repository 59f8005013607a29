// "-" as a file, several scenes in one command, and what is seen behind a scene.
#include "files.hpp"
#include "process.hpp"

#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <image/png_reader.hpp>
#include <nlohmann/json.hpp>
#include <prelight/image.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A shell's exit status for a line with pipes; `prelight` in it is the program.
int shell(const fs::path& folder, const std::string& line) {
    const std::string command =
        "cd '" + folder.string() + "' && prelight() { '" PRELIGHT_PROGRAM "' \"$@\"; } && " + line;
    std::ofstream(folder / "line.sh") << command << "\n";
    const int status = std::system(("bash '" + (folder / "line.sh").string() + "'").c_str());
    fs::remove(folder / "line.sh");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StandardStreams, TakeASceneAndGiveAPicture) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run({"make", "spheres", "--lights", "3", "-o", "s.glb"}, folder.path)));
    ASSERT_TRUE(succeeded(run({"render", "s.glb", "--size", "64x36", "-o", "a.png"}, folder.path)));
    ASSERT_EQ(shell(folder.path, "cat s.glb | prelight render - --size 64x36 -o - > b.png"), 0);
    EXPECT_TRUE(bytes_of(folder.path / "a.png") == bytes_of(folder.path / "b.png"));
    ASSERT_EQ(shell(folder.path, "prelight info - --json < s.glb > s.json"), 0);
    EXPECT_EQ(Json::parse(bytes_of(folder.path / "s.json")).at("world").at("lights"), 3);
    ASSERT_EQ(shell(folder.path, "prelight render spheres --size 8x8 -o c.png --stats - > stats.json"), 0);
    EXPECT_EQ(Json::parse(bytes_of(folder.path / "stats.json")).at("size"), Json({8, 8}));
    EXPECT_FALSE(fs::exists(folder.path / "-"));
}

TEST(StandardStreams, AreNamedInMessages) {
    const TemporaryFolder folder;
    EXPECT_EQ(shell(folder.path, "echo '{' | prelight render - -o a.png 2> said"), 1);
    EXPECT_THAT(bytes_of(folder.path / "said"), HasSubstr("prelight: standard input: "));
    EXPECT_EQ(shell(folder.path, "prelight render spheres --size 8x8 -o - > /dev/full 2> said"), 1);
    EXPECT_THAT(bytes_of(folder.path / "said"), HasSubstr("standard output"));
    EXPECT_TRUE(failed_with(run({"render", "spheres", "-o", "-", "--stats", "-"}, folder.path), 2));
    EXPECT_TRUE(failed_with(run({"render", "-", "-o", "a.png", "--watch"}, folder.path), 2));
    EXPECT_TRUE(failed_with(run({"bench", "encodings", "--json", "-"}, folder.path), 2));
}

TEST(SeveralScenes, GetANameEach) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run({"make", "spheres", "-o", "balls.glb"}, folder.path)));
    ASSERT_TRUE(succeeded(run({"render", "lights", "balls.glb", "--lights", "4", "--size", "32x18", "-o", "{name}.png",
                               "--view", "depth={name}-depth.png", "--stats", "{name}.json"},
                              folder.path)));
    for (const char* file :
         {"lights.png", "lights-depth.png", "lights.json", "balls.png", "balls-depth.png", "balls.json"})
        EXPECT_TRUE(fs::exists(folder.path / file)) << file;
    EXPECT_FALSE(bytes_of(folder.path / "lights.png") == bytes_of(folder.path / "balls.png"));
}

TEST(SeveralScenes, AreCheckedBeforeTheFirstIsDrawn) {
    const TemporaryFolder folder;
    const auto refused = [&](std::vector<std::string> arguments, const char* why) {
        arguments.insert(arguments.begin(), {"render", "--size", "8x8"});
        const Result result = run(arguments, folder.path);
        EXPECT_TRUE(failed_with(result, 2));
        EXPECT_THAT(result.err, HasSubstr(why));
    };
    refused({"lights", "spheres", "-o", "{name}.png", "--stats", "a.json"}, "a.json: 2 scenes need {name}");
    refused({"lights", "lights", "-o", "{name}.png"}, "lights.png: named for two outputs");
    refused({"lights", "sphers", "-o", "{name}.png"}, "did you mean spheres?");
    refused({"lights", "spheres", "-o", "{name}.png", "--watch"}, "--watch");
    EXPECT_EQ(folder.entries(), 0u);
}

/// Red to alpha, 0 … 255, row by row.
std::vector<uint8_t> rgba_of(const fs::path& file) {
    const std::string bytes = bytes_of(file);
    PngReader reader({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
    std::vector<uint8_t> pixels(size_t(reader.width()) * reader.height() * 4);
    for (uint32_t y = 0; y < reader.height(); ++y)
        reader.read_row(pixels.data() + size_t(y) * reader.width() * 4);
    return pixels;
}

class BehindTheScene : public testing::TestWithParam<const char*> {};

/// A pane at alpha 0.4 before nothing, beside a wall, seen straight on.
constexpr const char* pane = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
 "nodes": [{"mesh": 0, "translation": [-0.5, 0, 0]}, {"mesh": 1, "translation": [0.5, 0, 0]},
           {"camera": 0, "translation": [0, 0, 2]}],
 "cameras": [{"type": "orthographic", "orthographic": {"xmag": 1.6, "ymag": 0.9, "znear": 0.1, "zfar": 10}}],
 "materials": [{"alphaMode": "BLEND", "emissiveFactor": [0.2, 0.3, 0.1], "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.4]}},
               {"emissiveFactor": [0.5, 0.1, 0.1]}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]},
            {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 1}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-0.4, -0.4, 0], "max": [0.4, 0.4, 0]},
               {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
 "buffers": [{"uri": "pane.bin", "byteLength": 60}]})";

TEST_P(BehindTheScene, IsWhatWasAskedFor) {
    const TemporaryFolder folder;
    const float corners[12] = {-0.4f, -0.4f, 0, 0.4f, -0.4f, 0, 0.4f, 0.4f, 0, -0.4f, 0.4f, 0};
    const uint16_t indices[6] = {0, 1, 2, 0, 2, 3};
    std::ofstream(folder.path / "pane.bin", std::ios::binary)
        .write(reinterpret_cast<const char*>(corners), sizeof corners)
        .write(reinterpret_cast<const char*>(indices), sizeof indices);
    std::ofstream(folder.path / "pane.gltf") << pane;
    const auto draw = [&](const char* background) {
        EXPECT_TRUE(succeeded(run({"render", "pane.gltf", "--renderer", GetParam(), "--lights", "1", "--size", "64x36",
                                   "--msaa", "1", "--background", background, "-o", "a.png"},
                                  folder.path)));
        return rgba_of(folder.path / "a.png");
    };
    const std::vector<uint8_t> orange = draw("#ff8800"), clear = draw("transparent");
    const auto at = [](const std::vector<uint8_t>& picture, int x, int y) { return picture.data() + (y * 64 + x) * 4; };
    constexpr int empty[2]{2, 2}, through[2]{22, 18}, wall[2]{42, 18};
    EXPECT_EQ(at(clear, empty[0], empty[1])[3], 0);
    EXPECT_EQ(at(clear, wall[0], wall[1])[3], 255);
    EXPECT_NEAR(at(clear, through[0], through[1])[3], 0.4 * 255, 1);
    const int colour[3]{255, 136, 0};
    const auto light = [](int byte) { return srgb_decode(float(byte) / 255); };
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_EQ(at(orange, empty[0], empty[1])[channel], colour[channel]);
        EXPECT_EQ(at(orange, wall[0], wall[1])[channel], at(clear, wall[0], wall[1])[channel]);
        EXPECT_GT(at(clear, wall[0], wall[1])[channel], 0);
        const float own = 0.4f * light(at(clear, through[0], through[1])[channel]);
        EXPECT_GT(own, 0);
        EXPECT_NEAR(at(orange, through[0], through[1])[channel], 255 * srgb_encode(own + 0.6f * light(colour[channel])),
                    2);
    }
}
INSTANTIATE_TEST_SUITE_P(Renderers, BehindTheScene,
                         testing::Values("light-prepass", "deferred", "inferred", "multipass", "z-prepass",
                                         "reference"),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(Background, SaysWhatItTakes) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::vector<std::string>& arguments, const char* why) {
        const Result result = run(arguments, folder.path);
        EXPECT_TRUE(failed_with(result, 2));
        EXPECT_THAT(result.err, HasSubstr(why));
    };
    refused({"render", "spheres", "-o", "a.png", "--background", "oragne"}, "did you mean orange?");
    refused({"render", "spheres", "-o", "a.png", "--background", "#12345"}, "#12345");
    refused({"render", "spheres", "-o", "a.exr", "--background", "transparent"}, "PNG");
    refused({"compare", "spheres", "-o", "out", "--background", "white"}, "render alone");
    EXPECT_EQ(folder.entries(), 0u);
}

} // namespace
} // namespace prelight::test
