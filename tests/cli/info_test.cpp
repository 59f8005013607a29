// `prelight info`, and what packages are made of: manual pages and completion.
#include "files.hpp"
#include "process.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <options/option_table.hpp>
#include <prelight/renderer.hpp>

namespace prelight::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// One of each: a triangle, lights, cameras, an animation, extensions.
constexpr const char* small_scene = R"({
 "asset": {"version": "2.0", "generator": "a test\nof ours"}, "scene": 1,
 "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_unlit", "KHR_materials_clearcoat", "ACME_glow"],
 "extensionsRequired": ["KHR_lights_punctual"],
 "extensions": {"KHR_lights_punctual": {"lights": [
  {"name": "sun", "type": "directional", "intensity": 3},
  {"name": "lamp", "type": "spot", "intensity": 40, "range": 5, "color": [1, 0.5, 0],
   "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5235987756}}]}},
 "scenes": [{"name": "empty", "nodes": []}, {"name": "full", "nodes": [0, 1, 2, 3]}],
 "nodes": [{"mesh": 0}, {"camera": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}},
           {"extensions": {"KHR_lights_punctual": {"light": 1}}, "children": [4]},
           {"extensions": {"KHR_lights_punctual": {"light": 1}}}],
 "cameras": [{"name": "front", "type": "perspective", "perspective": {"yfov": 1.0471975512, "znear": 0.5}}],
 "materials": [{"name": "flat", "doubleSided": true, "alphaMode": "BLEND", "extensions": {"KHR_materials_unlit": {}}}],
 "meshes": [{"name": "triangle", "primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
 "animations": [{"name": "rise", "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                 "samplers": [{"input": 1, "output": 2}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
               {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [2.5]},
               {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                 {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
 "buffers": [{"uri": "data.bin", "byteLength": 68}]})";

class Info : public testing::Test {
protected:
    void SetUp() override {
        const float data[17] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2.5f, 0, 0, 0, 0, 1, 0};
        std::ofstream(folder_.path / "data.bin", std::ios::binary)
            .write(reinterpret_cast<const char*>(data), sizeof data);
        std::ofstream(folder_.path / "s.gltf") << small_scene;
    }
    TemporaryFolder folder_;
};

TEST_F(Info, TellsEverythingAsJson) {
    const Result result = run({"info", "s.gltf", "--json"}, folder_.path);
    ASSERT_TRUE(succeeded(result));
    const Json facts = Json::parse(result.out);
    EXPECT_EQ(facts.at("built_in"), false);
    EXPECT_EQ(facts.at("generator"), "a test\nof ours");
    EXPECT_EQ(facts.at("shown"), 1);
    EXPECT_EQ(facts.at("scenes").at(0).at("name"), "empty");
    EXPECT_EQ(facts.at("world").at("triangles"), 1);
    EXPECT_EQ(facts.at("world").at("lights"), 3);
    EXPECT_EQ(facts.at("world").at("bounds_m").at("max"), Json({1, 1, 0}));
    const Json& mesh = facts.at("meshes").at(0);
    EXPECT_EQ(mesh.at("vertices"), 3);
    EXPECT_EQ(mesh.at("materials"), Json({"flat"}));
    const Json& material = facts.at("materials").at(0);
    EXPECT_EQ(material.at("alpha"), "blend");
    EXPECT_EQ(material.at("shader"), "unlit");
    EXPECT_EQ(material.at("double_sided"), true);
    const Json &sun = facts.at("lights").at(0), &lamp = facts.at("lights").at(1);
    EXPECT_EQ(sun.at("unit"), "lx");
    EXPECT_EQ(sun.at("placed"), 1);
    EXPECT_EQ(lamp.at("unit"), "cd");
    EXPECT_EQ(lamp.at("intensity"), 40);
    EXPECT_EQ(lamp.at("placed"), 2);
    EXPECT_EQ(lamp.at("range_m"), 5);
    EXPECT_NEAR(lamp.at("outer_cone_degrees"), 30, 1e-4);
    EXPECT_NEAR(facts.at("cameras").at(0).at("yfov_degrees"), 60, 1e-6);
    EXPECT_TRUE(facts.at("cameras").at(0).at("far_m").is_null());
    EXPECT_EQ(facts.at("animations").at(0).at("seconds"), 2.5);
    // Three vectors a vertex of a flat triangle, its normals among them, and its indices.
    EXPECT_GE(facts.at("memory").at("geometry_bytes"), 3 * 24 + 12);
    EXPECT_EQ(facts.at("memory").at("files_bytes"), fs::file_size(folder_.path / "s.gltf") + 68);
}

TEST_F(Info, SaysHowFarEachExtensionIsHonoured) {
    const Json facts = Json::parse(run({"info", "s.gltf", "--json"}, folder_.path).out);
    std::map<std::string, Json> extensions;
    for (const Json& one : facts.at("extensions"))
        extensions[one.at("name")] = one;
    ASSERT_EQ(extensions.size(), 4u);
    EXPECT_EQ(extensions["KHR_lights_punctual"].at("honoured"), "whole");
    EXPECT_EQ(extensions["KHR_lights_punctual"].at("required"), true);
    EXPECT_EQ(extensions["KHR_lights_punctual"].at("objects"), 4) << "the list, and three nodes";
    EXPECT_EQ(extensions["KHR_materials_unlit"].at("objects"), 1);
    EXPECT_EQ(extensions["KHR_materials_clearcoat"].at("honoured"), "partly");
    EXPECT_EQ(extensions["KHR_materials_clearcoat"].at("objects"), 0);
    EXPECT_EQ(extensions["ACME_glow"].at("honoured"), "not");
    EXPECT_THAT(facts.at("warnings").dump(), HasSubstr("ACME_glow"));
}

TEST_F(Info, TellsPeopleInLines) {
    const Result result = run({"info", "s.gltf"}, folder_.path);
    ASSERT_TRUE(succeeded(result));
    for (const char* line :
         {"made by a test\\nof ours\n", "meshes (1)\n  0 triangle: 1 primitive, 1 triangles, 3 vertices\n",
          "  0 sun: directional, 3 lx,", "  1 lamp: spot, 40 cd,", ", on 2 nodes\n",
          "  0 front: perspective, 60° high, from 0.5 m to infinity\n", "  0 rise: 2.5 s, 1 channel, 2 keyframes\n",
          "ACME_glow: 0 objects: not honoured"})
        EXPECT_THAT(result.out, HasSubstr(line));
    EXPECT_EQ(result.err, "") << "warnings are part of what is told";
}

TEST_F(Info, KnowsBuiltInScenesAndRefusesTheRest) {
    const Json facts = Json::parse(run({"info", "spheres", "--lights", "7", "--json"}, folder_.path).out);
    EXPECT_EQ(facts.at("built_in"), true);
    EXPECT_EQ(facts.at("world").at("lights"), 7);
    EXPECT_TRUE(failed_with(run({"info", "sphers"}, folder_.path), 2));
    EXPECT_TRUE(failed_with(run({"info", "missing.glb"}, folder_.path), 1));
    EXPECT_TRUE(failed_with(run({"info", "s.gltf", "--strict"}, folder_.path), 1));
}

TEST(ManualPages, AreWhole) {
    const TemporaryFolder folder;
    for (const app::CommandRow& command : app::command_table()) {
        if (command.hidden)
            continue;
        const Result result = run({"man", std::string(command.name)}, folder.path);
        ASSERT_TRUE(succeeded(result));
        EXPECT_THAT(result.out, HasSubstr(".TH PRELIGHT\\-"));
        EXPECT_THAT(result.out, HasSubstr(".SH EXIT STATUS"));
        for (const app::OptionRow* row : app::options_of(command)) {
            std::string name = row->long_name(), escaped;
            for (const char c : name)
                escaped += c == '-' ? std::string("\\-") : std::string(1, c);
            EXPECT_THAT(result.out, HasSubstr(escaped)) << command.name;
        }
    }
    EXPECT_THAT(run({"man"}, folder.path).out, HasSubstr("NO_COLOR"));
    EXPECT_TRUE(failed_with(run({"man", "rendr"}, folder.path), 2));
}

/// What bash offers for the last of the words.
std::string offered(const fs::path& folder, const std::string& words) {
    const std::string script = fmt::format("cd '{}' && . ./prelight.bash && COMP_WORDS=(prelight {}) && "
                                           "COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)) && _prelight 2>/dev/null; "
                                           "echo \"${{COMPREPLY[*]}}\" > offered",
                                           folder.string(), words);
    std::ofstream(folder / "run.sh") << script;
    EXPECT_EQ(std::system(("bash '" + (folder / "run.sh").string() + "'").c_str()), 0);
    return bytes_of(folder / "offered");
}

TEST(Completion, OffersWhatCanBeTyped) {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "prelight.bash") << run({"completions", "bash"}, folder.path).out;
    EXPECT_EQ(offered(folder.path, "rend"), "render renderers\n");
    EXPECT_EQ(offered(folder.path, "render --expo"), "--exposure\n");
    EXPECT_EQ(offered(folder.path, "compare --tone"), "\n") << "an option of other commands";
    EXPECT_EQ(offered(folder.path, "render city --renderer d"), "deferred\n");
    EXPECT_EQ(offered(folder.path, "render city --set light-cul"), "light-culling=\n");
    EXPECT_THAT(offered(folder.path, "bench enc"), HasSubstr("encodings"));
    EXPECT_EQ(offered(folder.path, "make sph"), "spheres\n");
}

TEST(Completion, IsForThreeShells) {
    const TemporaryFolder folder;
    const std::string zsh = run({"completions", "zsh"}, folder.path).out;
    const std::string fish = run({"completions", "fish"}, folder.path).out;
    EXPECT_TRUE(zsh.starts_with("#compdef prelight\n"));
    for (const app::OptionRow& row : app::option_table()) {
        EXPECT_THAT(zsh, HasSubstr(row.long_name()));
        EXPECT_THAT(fish, HasSubstr(" -l " + row.long_name().substr(2) + " "));
    }
    EXPECT_THAT(zsh, HasSubstr("'--renderer=[")) << "with its value after a space or =";
    EXPECT_THAT(zsh, HasSubstr(": _alternative \"words\\:word\\:(none studio)\" \"files\\:file\\:_files\"'"));
    EXPECT_THAT(zsh, Not(HasSubstr(":_alternative"))) << "_arguments would call it with options that it does not know";
    std::string quotes = zsh; // each closed, but for those of texts
    for (size_t at; (at = quotes.find("'\\''")) != quotes.npos;)
        quotes.erase(at, 4);
    EXPECT_EQ(std::ranges::count(quotes, '\'') % 2, 0);
    EXPECT_THAT(run({"--help"}, folder.path).out, Not(HasSubstr("completions")));
    EXPECT_TRUE(failed_with(run({"completions", "csh"}, folder.path), 2));
}

} // namespace
} // namespace prelight::test
