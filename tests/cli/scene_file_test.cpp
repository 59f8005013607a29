// Faulty scene files: repaired with a warning by default, an error with --strict; which of a file's scenes; files
// without anything to see.
#include "files.hpp"
#include "process.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <prelight/image.hpp>

namespace prelight::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// One triangle, and a camera in front of it.
Json triangle() {
    return Json::parse(
        R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"name": "full", "nodes": [0, 1]}, {"name": "empty", "nodes": [1]}],
        "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 3]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:;base64,AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAAAAAAAAgD8AAAAA"}]})");
}

Json with_faulty_light() {
    Json json = triangle();
    json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "ambient"}}, {{"type", "directional"}, {"intensity", 3}}});
    json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    return json;
}

struct Files : TemporaryFolder {
    void write(const std::string& name, const std::string& text) const { test::write(path / name, text); }
    Result render(const std::vector<std::string>& more) const {
        return run(joined({"render", "a.gltf", "-o", "a.png", "--size", "64x36", "--msaa", "1"}, more), path);
    }
};

constexpr const char* left_out = "a.gltf: light 0: type \"ambient\" is not known; the light is left out";

TEST(SceneFile, AFaultyLightIsAWarning) {
    Files files;
    files.write("a.gltf", with_faulty_light().dump());
    const Result result = files.render({"--stats", "a.json"});
    ASSERT_TRUE(succeeded(result));
    EXPECT_THAT(result.err, StartsWith(std::string("warning: ") + left_out + "\n"));
    const Json stats = Json::parse(std::ifstream(files.path / "a.json"));
    EXPECT_EQ(stats.at("warnings"), Json::array({left_out}));
    EXPECT_EQ(stats.at("lights"), 1);
}

TEST(SceneFile, StrictMakesTheWarningAnError) {
    Files files;
    files.write("a.gltf", with_faulty_light().dump());
    const Result result = files.render({"--strict"});
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_EQ(result.err, std::string("prelight: ") + left_out + "\n");
    EXPECT_EQ(files.entries(), 1u);
    files.write("a.gltf", triangle().dump());
    EXPECT_TRUE(succeeded(files.render({"--strict"})));
    EXPECT_TRUE(failed_with(files.render({"--strict", "--scene", "empty"}), 1)) << "nothing to see is a warning too";
}

TEST(SceneFile, TheLogLevelSaysWhatIsShown) {
    Files files;
    files.write("a.gltf", with_faulty_light().dump());
    EXPECT_EQ(files.render({"--log-level", "error"}).err, "");
    EXPECT_THAT(files.render({"--log-level", "warning"}).err, StartsWith("warning: "));
    EXPECT_THAT(files.render({"--log-level", "info"}).err, StartsWith("warning: "));
    EXPECT_TRUE(failed_with(files.render({"--log-level", "loud"}), 2));
    files.write("a.gltf", "{");
    const Result broken = files.render({"--log-level", "error"});
    EXPECT_TRUE(failed_with(broken, 1)) << "why it failed is always told";
}

TEST(SceneFile, OneOfItsScenes) {
    Files files;
    files.write("a.gltf", triangle().dump());
    const auto middle = [&] { return load_png(files.path / "a.png").at(32, 18).r; };
    for (const char* scene : {"full", "0"}) {
        ASSERT_TRUE(succeeded(files.render({"--scene", scene})));
        EXPECT_GT(middle(), 0.05f) << scene;
    }
    for (const char* scene : {"empty", "1"}) {
        const Result result = files.render({"--scene", scene, "--environment", "none"});
        ASSERT_TRUE(succeeded(result));
        EXPECT_THAT(result.err, HasSubstr("no triangles, so the picture is empty"));
        EXPECT_EQ(middle(), 0) << scene;
    }
    const Result none = files.render({"--scene", "third"});
    EXPECT_TRUE(failed_with(none, 2));
    EXPECT_THAT(none.err, HasSubstr("--scene third: no such scene; there is 0 \"full\", 1 \"empty\""));
}

TEST(SceneFile, WithoutTrianglesIsAnEmptyPictureInEveryRenderer) {
    Files files;
    Json json = with_faulty_light();
    json["nodes"][0].erase("mesh");
    json["extensions"]["KHR_lights_punctual"]["lights"][0] = {{"type", "point"}};
    files.write("a.gltf", json.dump());
    for (const char* renderer : {"light-prepass", "deferred", "z-prepass", "multipass", "reference"}) {
        const Result result = files.render({"--renderer", renderer});
        ASSERT_TRUE(succeeded(result)) << renderer;
        EXPECT_EQ(result.err, "warning: a.gltf: scene: no triangles, so the picture is empty; the file has 2 nodes "
                              "with a light, 1 node with a camera\n");
        const Image image = load_png(files.path / "a.png");
        for (const glm::vec3& pixel : image.pixels)
            ASSERT_EQ(pixel, glm::vec3(0)) << renderer;
    }
    EXPECT_TRUE(succeeded(files.render({"--lights", "9"}))) << "lights within bounds that hold nothing";
    for (const char* table : {"meshes", "accessors", "bufferViews", "buffers"})
        json.erase(table);
    files.write("a.gltf", json.dump());
    for (const char* renderer : {"light-prepass", "deferred", "z-prepass", "multipass", "reference"})
        EXPECT_TRUE(succeeded(files.render({"--renderer", renderer}))) << renderer << ": a file with no mesh at all";
    files.write("a.gltf", R"({"asset": {"version": "2.0"}})");
    EXPECT_TRUE(succeeded(files.render({}))) << "nor anything else";
}

TEST(SceneFile, WithoutTrianglesGoesThroughCompareAndBench) {
    Files files;
    Json json = triangle();
    json["nodes"][0].erase("mesh");
    files.write("a.gltf", json.dump());
    const Result compared = run({"compare", "a.gltf", "-o", "report", "--size", "64x36", "--frames", "1",
                                 "--light-counts", "none", "--renderers", "light-prepass,deferred"},
                                files.path);
    EXPECT_EQ(compared.status, 0) << compared.err;
    const Result bench = run({"bench", "a.gltf", "--size", "64x36", "--frames", "1", "--lights", "4"}, files.path);
    EXPECT_EQ(bench.status, 0) << bench.err;
}

TEST(SceneFile, NamesAreEscapedInEveryMessage) {
    Files files;
    const std::string name = "a\x1b[31m\nb.gltf";
    files.write(name, with_faulty_light().dump());
    const Result warned = run({"render", name, "-o", "a\tb.png", "--size", "64x36", "--msaa", "1"}, files.path);
    EXPECT_EQ(warned.status, 0);
    EXPECT_THAT(warned.err, StartsWith("warning: a\\x1b[31m\\nb.gltf: light 0"));
    EXPECT_THAT(warned.out, StartsWith("a\\tb.png: 64x36"));
    files.write(name, "no glTF");
    const Result failed = run({"render", name, "-o", "a.png"}, files.path);
    EXPECT_TRUE(failed_with(failed, 1));
    EXPECT_EQ(failed.err,
              "prelight: a\\x1b[31m\\nb.gltf: file: is no glTF file: it is neither GLB nor a JSON object\n");
}

} // namespace
} // namespace prelight::test
