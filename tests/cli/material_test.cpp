// Materials of the user's own, and the list of those that are built in.
#include "files.hpp"
#include "process.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <gmock/gmock.h>
#include <map>
#include <memory>
#include <prelight/image.hpp>
#include <thread>

namespace prelight::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// The first block of GLSL in docs/materials.md: what a reader types.
std::string documented_material() {
    const std::string text = bytes_of(fs::path(PRELIGHT_SOURCE_DIR) / "docs/materials.md");
    const size_t start = text.find("```glsl\n") + 8;
    return text.substr(start, text.find("```", start) - start);
}

const std::vector<std::string> render_spheres{"render", "spheres", "--lights", "2",  "--size",
                                              "64x36",  "--msaa",  "1",        "-o", "a.png"};

TEST(Material, TheOneOfTheDocumentationWorksAsTypedInEveryArchitecture) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(render_spheres, folder.path)));
    const std::string plain = bytes_of(folder.path / "a.png");
    write(folder.path / "toon.glsl", documented_material());
    for (const char* renderer : {"light-prepass", "multipass", "z-prepass", "deferred"}) {
        const Result result =
            run(joined(render_spheres, {"--renderer", renderer, "--material", "floor=toon.glsl", "--validate"}),
                folder.path);
        ASSERT_TRUE(succeeded(result)) << renderer;
        EXPECT_FALSE(bytes_of(folder.path / "a.png") == plain) << renderer;
    }
}

TEST(Material, WrongUsageAndMistakesAreOneLine) {
    const TemporaryFolder folder;
    const std::string good = documented_material();
    write(folder.path / "toon.glsl", good);
    const Result unknown = run(joined(render_spheres, {"--material", "roof=toon.glsl"}), folder.path);
    EXPECT_TRUE(failed_with(unknown, 2));
    EXPECT_THAT(unknown.err, HasSubstr("--material roof: spheres has no such material (floor"));
    const Result form = run(joined(render_spheres, {"--material", "toon.glsl"}), folder.path);
    EXPECT_TRUE(failed_with(form, 2));
    const Result missing = run(joined(render_spheres, {"--material", "floor=no.glsl"}), folder.path);
    EXPECT_TRUE(failed_with(missing, 1));
    EXPECT_THAT(missing.err, HasSubstr("no.glsl: cannot be opened (No such file"));
    write(folder.path / "bad.glsl", good + "float lines = none;\n");
    const Result mistake = run(joined(render_spheres, {"--material", "floor=bad.glsl"}), folder.path);
    EXPECT_TRUE(failed_with(mistake, 1));
    const auto line = std::count(good.begin(), good.end(), '\n') + 1;
    EXPECT_THAT(mistake.err, HasSubstr("bad.glsl:" + std::to_string(line) + ": 'none' : undeclared identifier"));
    EXPECT_FALSE(fs::exists(folder.path / "a.png"));
}

/// Names of the files that keep what was compiled, with when they were written.
std::map<std::string, fs::file_time_type> kept_code(const fs::path& cache) {
    std::map<std::string, fs::file_time_type> files;
    for (std::error_code none; const auto& entry : fs::directory_iterator(cache / "prelight/materials", none))
        files[entry.path().filename()] = entry.last_write_time();
    return files;
}

TEST(Material, IsCompiledOnceAndOnlyForWhatDrawsWithIt) {
    const TemporaryFolder folder, cache;
    const std::map<std::string, std::string> environment{{"XDG_CACHE_HOME", cache.path}};
    write(folder.path / "toon.glsl", documented_material());
    const auto render = [&](const char* renderer) {
        EXPECT_TRUE(succeeded(run(joined(render_spheres, {"--renderer", renderer, "--material", "floor=toon.glsl"}),
                                  folder.path, {}, environment)));
        return bytes_of(folder.path / "a.png");
    };
    const std::string first = render("light-prepass");
    const auto kept = kept_code(cache.path);
    EXPECT_EQ(kept.size(), 4u) << "two that look for mistakes, and the two passes over all geometry";
    EXPECT_TRUE(render("light-prepass") == first);
    EXPECT_TRUE(kept_code(cache.path) == kept) << "it was compiled again";
    render("deferred");
    EXPECT_EQ(kept_code(cache.path).size(), 5u) << "the G-buffer's pass alone is new";

    // Damage is found, and another source is another key.
    for (const auto& [name, time] : kept) {
        const fs::path file = cache.path / "prelight/materials" / name;
        std::string bytes = bytes_of(file);
        bytes[bytes.size() / 2] ^= 1;
        write(file, bytes);
    }
    EXPECT_TRUE(render("light-prepass") == first);
    write(folder.path / "toon.glsl", documented_material() + "\n// changed\n");
    render("light-prepass");
    EXPECT_EQ(kept_code(cache.path).size(), 9u);
}

TEST(Material, ProcessesThatCompileAtOnceDoNotDisturbEachOther) {
    const TemporaryFolder cache;
    const std::map<std::string, std::string> environment{{"XDG_CACHE_HOME", cache.path}};
    std::vector<std::unique_ptr<TemporaryFolder>> folders;
    std::vector<std::unique_ptr<Prelight>> programs;
    for (int i = 0; i < 3; ++i) {
        folders.push_back(std::make_unique<TemporaryFolder>());
        write(folders.back()->path / "toon.glsl", documented_material());
        programs.push_back(std::make_unique<Prelight>(joined(render_spheres, {"--material", "floor=toon.glsl"}),
                                                      folders.back()->path, environment));
    }
    for (const auto& program : programs)
        EXPECT_TRUE(succeeded(program->wait()));
    for (const auto& folder : folders)
        EXPECT_TRUE(bytes_of(folder->path / "a.png") == bytes_of(folders[0]->path / "a.png"));
    for (const auto& [name, time] : kept_code(cache.path))
        EXPECT_TRUE(name.ends_with(".spv")) << name << ": a temporary file was left behind";
}

TEST(Material, IsTakenUpUnderWatchAndAMistakeKeepsTheLastThatWorked) {
    const TemporaryFolder folder;
    const auto shade = [&](const char* colour) {
        write(folder.path / "m.glsl", std::string("Surface surface(Point p) { return gltf_surface(p); }\nvec3 "
                                                  "shade(Point p, Surface s, Light light) { return ") +
                                          colour + "; }\n");
    };
    const auto shows_floor = [&](int channel) {
        const glm::vec3 colour = load_png(folder.path / "a.png").at(32, 34);
        return colour[channel] > 0.5f && colour[(channel + 1) % 3] < 0.3f;
    };
    shade("vec3(1.0, 0.0, 0.0)");
    Prelight program(joined(render_spheres, {"--material", "floor=m.glsl", "--watch", "--tonemap", "none"}),
                     folder.path);
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
    for (const char* text : {"skin: ", "minnaert: ", "reflection: ", "fresnel-rim: ", "detailed: ", "blinn-phong: ",
                             "roll_off = 0.4   (0 … 2)", "height_map: texture"})
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
