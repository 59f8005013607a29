// Materials of the user's own, and the list of those that are built in.
#include "process.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <prelight/image.hpp>
#include <sstream>
#include <thread>

namespace prelight::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// The first block of GLSL in docs/materials.md: what a reader types.
std::string documented_material() {
    const std::string text = text_of(fs::path(PRELIGHT_SOURCE_DIR) / "docs/materials.md");
    const size_t start = text.find("```glsl\n") + 8;
    return text.substr(start, text.find("```", start) - start);
}

const std::vector<std::string> small{"render", "spheres", "--lights", "2", "--size", "64x36", "-o", "a.png"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Material, TheOneOfTheDocumentationWorksAsTypedInEveryArchitecture) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(small, folder.path)));
    const std::string plain = text_of(folder.path / "a.png");
    write(folder.path / "toon.glsl", documented_material());
    for (const char* renderer : {"light-prepass", "multipass", "z-prepass", "deferred"}) {
        const Result result = run(with(small, {"--renderer", renderer, "--material", "floor=toon.glsl", "--validate"}), folder.path);
        ASSERT_TRUE(succeeded(result)) << renderer;
        EXPECT_FALSE(text_of(folder.path / "a.png") == plain) << renderer;
    }
}

TEST(Material, WrongUsageAndMistakesAreOneLine) {
    const TemporaryFolder folder;
    const std::string good = documented_material();
    write(folder.path / "toon.glsl", good);
    const Result unknown = run(with(small, {"--material", "roof=toon.glsl"}), folder.path);
    EXPECT_TRUE(failed_with(unknown, 2));
    EXPECT_THAT(unknown.err, HasSubstr("--material roof: spheres has no such material (floor"));
    const Result form = run(with(small, {"--material", "toon.glsl"}), folder.path);
    EXPECT_TRUE(failed_with(form, 2));
    const Result missing = run(with(small, {"--material", "floor=no.glsl"}), folder.path);
    EXPECT_TRUE(failed_with(missing, 1));
    EXPECT_THAT(missing.err, HasSubstr("no.glsl: cannot be opened (No such file"));
    write(folder.path / "bad.glsl", good + "float lines = none;\n");
    const Result mistake = run(with(small, {"--material", "floor=bad.glsl"}), folder.path);
    EXPECT_TRUE(failed_with(mistake, 1));
    const auto line = std::count(good.begin(), good.end(), '\n') + 1;
    EXPECT_THAT(mistake.err, HasSubstr("bad.glsl:" + std::to_string(line) + ": 'none' : undeclared identifier"));
    EXPECT_FALSE(fs::exists(folder.path / "a.png"));
}

TEST(Material, IsTakenUpUnderWatchAndAMistakeKeepsTheLastThatWorked) {
    const TemporaryFolder folder;
    const auto eventually = [](const std::function<bool()>& condition) {
        for (const auto end = std::chrono::steady_clock::now() + 60s; std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(5ms))
            if (condition())
                return true;
        return false;
    };
    const auto shade = [&](const char* colour) {
        write(folder.path / "m.glsl", std::string("Surface surface(Point p) { return gltf_surface(p); }\nvec3 shade(Point p, Surface s, Light light) { return ") + colour + "; }\n");
    };
    const auto shows_floor = [&](int channel) {
        const glm::vec3 colour = load_png(folder.path / "a.png").at(32, 34);
        return colour[channel] > 0.5f && colour[(channel + 1) % 3] < 0.3f;
    };
    shade("vec3(1.0, 0.0, 0.0)");
    Prelight program(with(small, {"--material", "floor=m.glsl", "--watch", "--tonemap", "none"}), folder.path);
    ASSERT_TRUE(eventually([&] { return fs::exists(folder.path / "a.png"); }));
    EXPECT_TRUE(shows_floor(0));
    shade("vec3(0.0, 1.0, 0.0");
    std::this_thread::sleep_for(1500ms);
    ASSERT_TRUE(program.running());
    EXPECT_TRUE(shows_floor(0));
    shade("vec3(0.0, 0.0, 1.0)");
    EXPECT_TRUE(eventually([&] { return shows_floor(2); }));
    program.send(SIGINT);
    const Result result = program.wait();
    EXPECT_THAT(result.err, HasSubstr("m.glsl:2: "));
    EXPECT_THAT(result.err, HasSubstr("floor stays as it was"));
}

TEST(Material, BuiltInOnesAreListedWithTheirParameters) {
    const TemporaryFolder folder;
    const Result all = run({"materials"}, folder.path);
    ASSERT_TRUE(succeeded(all));
    for (const char* text : {"skin: ", "minnaert: ", "reflection: ", "fresnel-rim: ", "detailed: ", "blinn-phong: ", "roll_off = 0.4   (0 … 2)", "height_map: texture"})
        EXPECT_THAT(all.out, HasSubstr(text));
    const Result one = run({"materials", "skin"}, folder.path);
    ASSERT_TRUE(succeeded(one));
    EXPECT_THAT(one.out, testing::Not(HasSubstr("minnaert:")));
    const Result none = run({"materials", "skn"}, folder.path);
    EXPECT_TRUE(failed_with(none, 2));
    EXPECT_THAT(none.err, HasSubstr("skn: not a built-in material (blinn-phong"));
}

} // namespace
} // namespace prelight::test
