// `prelight compare`: the report's figures, the page in a browser, and the folder that holds them.
#include "files.hpp"
#include "process.hpp"
#include "spread.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <prelight/image.hpp>
#include <prelight/scene_io.hpp>
#include <thread>

namespace prelight::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A name that would end or confuse a page that did not take care of it.
constexpr const char* awkward_scene = "x<!--<script>&amp;'\".glb";

Json report_of(const fs::path& folder) { return Json::parse(bytes_of(folder / "report.json")); }

std::vector<std::string> small_comparison(const std::vector<std::string>& more) {
    return joined({"compare", "spheres", "--size", "64x36", "--frames", "1"}, more);
}

/// One report for the tests that only look at it.
class CompareReport : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        ASSERT_TRUE(succeeded(run({"make", "spheres", "--lights", "4", "-o", awkward_scene}, folder_->path)));
        made_ =
            run({"compare", awkward_scene, "--size", "160x90", "--frames", "3", "--light-counts", "1,4", "--renderers",
                 "light-prepass,multipass@lights-per-pass=8@order=objects,z-prepass,"
                 "light-prepass@model=full",
                 "--device", "cpu", "--validate", "-o", "report"},
                folder_->path);
    }
    static void TearDownTestSuite() { folder_.reset(); }
    void SetUp() override { ASSERT_TRUE(succeeded(made_)); }
    static fs::path report() { return folder_->path / "report"; }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline Result made_;
};

/// The keys that every run of every command has (`--stats`).
void expect_stats(const Json& run) {
    for (const char* key :
         {"device", "driver", "scene", "renderer", "preset", "settings", "size", "msaa", "shading", "lights",
          "triangles", "draws", "frames", "attachment_bytes", "device_bytes", "light_pixel_pairs"})
        EXPECT_TRUE(run.contains(key)) << key;
    for (const char* key : {"wall_ms", "cpu_ms", "gpu_ms"})
        expect_spread(run.at(key));
    EXPECT_GT(run.at("wall_ms").at("min"), 0);
    ASSERT_FALSE(run.at("passes").empty());
    for (const Json& pass : run.at("passes")) {
        expect_spread(pass.at("gpu_ms"));
        const auto name = pass.at("name").get<std::string>();
        if (name != "depth-range" && name.find("-lists ") == std::string::npos) { // these write buffers alone
            EXPECT_GT(pass.at("bytes_written"), 0) << name;
        }
    }
}

TEST_F(CompareReport, HoldsEveryFigureOfEachVariant) {
    const Json json = report_of(report());
    EXPECT_EQ(json.at("prelight_report"), 1);
    EXPECT_EQ(json.at("scene"), awkward_scene);
    EXPECT_EQ(json.at("size"), Json({160, 90}));
    EXPECT_EQ(json.at("lights"), 4);
    EXPECT_EQ(json.at("lights_added"), 0);
    ASSERT_EQ(json.at("runs").size(), 4u);
    for (const Json& run : json.at("runs")) {
        if (!run.at("error").is_null())
            continue;
        expect_stats(run);
        EXPECT_EQ(run.at("frames"), 3);
        EXPECT_EQ(run.at("lights"), 4);
        EXPECT_GT(run.at("difference").at("psnr"), 50) << run.at("variant");
        EXPECT_LT(run.at("difference").at("flip"), 0.02);
        const Json& pairs = run.at("light_pixel_pairs");
        EXPECT_GT(pairs.at("contributing"), 1000);
        EXPECT_GE(pairs.at("evaluated"), pairs.at("contributing"));
        for (const auto& [view, file] : run.at("pictures").items())
            EXPECT_EQ(load_png(report() / file.get<std::string>()).width, 160u) << view;
        EXPECT_TRUE(run.at("pictures").contains("final") && run.at("pictures").contains("difference"));
    }
    EXPECT_EQ(json.at("runs")[0].at("variant"), "light-prepass");
    EXPECT_EQ(json.at("runs")[0].at("reference_form"), "ggx, Fresnel weighted over the lights");
    EXPECT_EQ(json.at("runs")[1].at("settings").at("order"), "objects");
    EXPECT_EQ(json.at("runs")[1].at("reference_form"), "ggx, Fresnel of each light");
}

/// By hand for 160×90 pixels of the light pre-pass's defaults: depth 4 bytes, normals 4, light 8 + 8,
/// final 4, tone mapped by the material pass.
TEST_F(CompareReport, BytesFollowFromTheFormats) {
    const Json run = report_of(report()).at("runs")[0];
    const uint64_t pixels = 160 * 90;
    uint64_t moved = 0;
    for (const Json& pass : run.at("passes"))
        moved += pass.at("bytes_read").get<uint64_t>() + pass.at("bytes_written").get<uint64_t>();
    const auto expect = [&](const char* name, uint64_t read, uint64_t written) {
        const auto pass = std::ranges::find(run.at("passes"), name, [](const Json& p) { return p.at("name"); });
        ASSERT_NE(pass, run.at("passes").end()) << name;
        EXPECT_EQ(pass->at("bytes_read"), read * pixels) << name;
        EXPECT_EQ(pass->at("bytes_written"), written * pixels) << name;
        moved -= (read + written) * pixels;
    };
    expect("depth-normal", 0, 4 + 4);
    expect("depth-range", 4, 0);
    expect("light clear", 0, 16);
    expect("light", 4 + 4, 16); // depth and normals; the light buffer is written once
    expect("material", 4 + 16, 4);
    EXPECT_EQ(moved, 0u) << "no other pass reads or writes an image";
    EXPECT_EQ(run.at("attachment_bytes_per_pixel").at("unshared"), 28);
    EXPECT_LT(run.at("attachment_bytes_per_pixel").at("shared"), 28);
}

TEST_F(CompareReport, AVariantThatFailsIsToldAndTheOthersGoOn) {
    const Json failed = report_of(report()).at("runs")[3];
    EXPECT_EQ(failed.at("variant"), "light-prepass@model=full");
    EXPECT_THAT(failed.at("error").get<std::string>(), HasSubstr("model=full"));
    EXPECT_FALSE(failed.contains("gpu_ms"));
    EXPECT_THAT(made_.out, HasSubstr("1 failed"));
}

TEST_F(CompareReport, TimesEachNumberOfLights) {
    const Json json = report_of(report());
    ASSERT_EQ(json.at("light_counts").size(), 3u) << "the one that failed has none";
    for (const Json& line : json.at("light_counts")) {
        // 1 and 4 are added to the file's four, which are a point themselves.
        std::vector<int> lights;
        for (const Json& point : line.at("points")) {
            expect_stats(point);
            lights.push_back(point.at("lights"));
        }
        EXPECT_EQ(lights, (std::vector<int>{4, 5, 8}));
        EXPECT_TRUE(line.at("us_per_light").is_number());
        EXPECT_GT(line.at("us_per_light_error"), 0);
        EXPECT_GT(line.at("cpu_us_per_light_error"), 0);
        EXPECT_TRUE(line.at("stopped").is_null());
    }
    // The z pre-pass lights and shades in one pass; the others have one for lights alone.
    const auto share = [&](size_t line) {
        return json.at("light_counts")[line].at("points")[0].at("light_pass_share");
    };
    EXPECT_GT(share(0), 0);
    EXPECT_LT(share(0), 1);
    EXPECT_GT(share(1), 0);
    EXPECT_TRUE(share(2).is_null());
}

TEST_F(CompareReport, ABrowserShowsItWithoutAComplaint) {
    for (const char* program : {"node", "chromium"})
        if (std::system(fmt::format("{} --version > /dev/null 2>&1", program).c_str()) != 0)
            GTEST_SKIP() << program << " is missing";
    const char* shots = std::getenv("PRELIGHT_TEST_PICTURES");
    const fs::path said = folder_->path / "said";
    const std::string command =
        fmt::format("timeout -k 5 240 node '{}/tests/page/report.js' '{}' {} > '{}' 2>&1", PRELIGHT_SOURCE_DIR,
                    report().string(), shots ? fmt::format("'{}'", shots) : "", said.string());
    EXPECT_EQ(std::system(command.c_str()), 0) << bytes_of(said);
}

TEST(Compare, ASlowFrameEndsTheLine) {
    const TemporaryFolder folder;
    ASSERT_TRUE(
        succeeded(run({"compare", "spheres", "--size", "64x36", "--frames", "3", "--frame-limit", "0", "--light-counts",
                       "1,2,4,16", "--renderers", "light-prepass", "--lights", "4", "-o", "report"},
                      folder.path)));
    const Json json = report_of(folder.path / "report");
    const Json& line = json.at("light_counts").at(0);
    EXPECT_EQ(line.at("points").size(), 1u);
    EXPECT_THAT(line.at("stopped").get<std::string>(), HasSubstr("no more than 1 light:"));
    EXPECT_TRUE(line.at("us_per_light").is_null());
    EXPECT_EQ(json.at("runs")[0].at("lights"), 4) << "the scene's own number is timed all the same";
    EXPECT_EQ(json.at("runs")[0].at("frames"), 1);
}

TEST(Compare, ASlowFrameAtTheLastNumberEndsNothing) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(small_comparison({"--frame-limit", "0", "--light-counts", "4", "--lights", "4",
                                                "--renderers", "light-prepass", "-o", "report"}),
                              folder.path)));
    EXPECT_TRUE(report_of(folder.path / "report").at("light_counts").at(0).at("stopped").is_null());
}

TEST(Compare, TheMomentReachesThePictures) {
    const TemporaryFolder folder;
    const auto picture = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments =
            joined(small_comparison({"--light-counts", "none", "--renderers", "light-prepass", "-o", "report"}), more);
        arguments[1] = "motion";
        EXPECT_TRUE(succeeded(run(arguments, folder.path)));
        EXPECT_GT(report_of(folder.path / "report").at("runs")[0].at("difference").at("psnr"), 40);
        return bytes_of(folder.path / "report/pictures/light-prepass-final.png");
    };
    const std::string start = picture({"--time", "0"});
    EXPECT_NE(start, picture({"--time", "0.7"}));
    EXPECT_EQ(start, picture({"--time", "0"}));
}

TEST(Compare, ATerminalSeesABar) {
    if (std::system("script --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "script, which makes a terminal, is missing";
    const TemporaryFolder folder;
    const std::string command = fmt::format(
        "cd '{}' && script -qec \"stty cols 120; '{}' compare spheres --size 64x36 --frames 1 --light-counts none "
        "--renderers light-prepass -o report\" /dev/null > said",
        folder.path.string(), PRELIGHT_PROGRAM);
    ASSERT_EQ(std::system(command.c_str()), 0);
    const std::string said = bytes_of(folder.path / "said");
    EXPECT_THAT(said, HasSubstr("\r[")) << "redrawn in place";
    EXPECT_THAT(said, HasSubstr("picture of light-prepass"));
    EXPECT_THAT(said, HasSubstr("\r\033[Kreport/index.html")) << "cleared before the result";
}

TEST(Compare, AFileWithoutLightsGetsSome) {
    const TemporaryFolder folder;
    Scene scene = make_scene("spheres", 1, 1);
    for (Node& node : scene.nodes)
        node.light.reset();
    scene.lights.clear();
    save_glb(scene, folder.path / "dark.glb");
    const auto lights = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments =
            joined(small_comparison({"--light-counts", "none", "--renderers", "light-prepass", "-o", "report"}), more);
        arguments[1] = "dark.glb";
        EXPECT_TRUE(succeeded(run(arguments, folder.path)));
        const Json json = report_of(folder.path / "report");
        return std::pair(json.at("lights").get<int>(), json.at("lights_added").get<int>());
    };
    EXPECT_EQ(lights({}), std::pair(256, 256));
    EXPECT_EQ(lights({"--lights", "3"}), std::pair(3, 3));
}

TEST(Compare, ReplacesAnEarlierReportAndNothingElse) {
    const TemporaryFolder folder;
    const auto compare = [&](const char* place) {
        return run(small_comparison({"--light-counts", "none", "--renderers", "light-prepass", "-o", place}),
                   folder.path);
    };
    fs::create_directory(folder.path / "report");
    ASSERT_TRUE(succeeded(compare("report"))) << "an empty folder";
    fs::create_directory_symlink("report", folder.path / "link");
    ASSERT_TRUE(succeeded(compare("report/"))) << "an earlier report";
    ASSERT_TRUE(succeeded(compare("link"))) << "by a link";
    EXPECT_TRUE(fs::is_symlink(folder.path / "link"));
    EXPECT_TRUE(fs::exists(folder.path / "report/index.html"));

    for (const char* mine : {"report/pictures/mine.png", "report/diary.txt", "report/.hidden"}) {
        std::ofstream(folder.path / mine) << "mine";
        const Result result = compare("report");
        EXPECT_TRUE(failed_with(result, 1)) << "somebody else's file lies in it";
        EXPECT_THAT(result.err, HasSubstr(fs::path(mine).filename().string()));
        EXPECT_LT(result.seconds, 20) << "it was told after the work";
        EXPECT_EQ(bytes_of(folder.path / mine), "mine");
        fs::remove(folder.path / mine);
    }
    fs::rename(folder.path / "report/pictures/light-prepass-final.png", folder.path / "kept.png");
    fs::create_symlink("../../kept.png", folder.path / "report/pictures/light-prepass-final.png");
    EXPECT_TRUE(failed_with(compare("report"), 1)) << "a link where a picture was";
    fs::remove(folder.path / "report/pictures/light-prepass-final.png");
    ASSERT_TRUE(succeeded(compare("report"))) << "a picture less";
    EXPECT_TRUE(fs::exists(folder.path / "kept.png"));
    fs::create_directory(folder.path / "other");
    std::ofstream(folder.path / "other/report.json") << R"({"not": "ours"})";
    EXPECT_TRUE(failed_with(compare("other"), 1));
    std::ofstream(folder.path / "file") << "mine";
    EXPECT_TRUE(failed_with(compare("file"), 1));
    EXPECT_EQ(bytes_of(folder.path / "file"), "mine");
    EXPECT_TRUE(failed_with(compare("nowhere/report"), 1));
    EXPECT_EQ(folder.entries(), 5u) << "something was left behind";
}

TEST(Compare, TellsEachStepWhereThereIsNoTerminal) {
    const TemporaryFolder folder;
    // Large enough for more than a second, after which the time that is left can be told.
    const Result result = run({"compare", "spheres", "--size", "480x270", "--frames", "1", "--light-counts", "1,2",
                               "--renderers", "light-prepass,deferred", "-o", "report"},
                              folder.path);
    ASSERT_TRUE(succeeded(result));
    for (const char* step : {"%] 0:", ": reference\n", "picture of light-prepass\n", "picture of deferred\n",
                             "frames with 1 light\n", "frames with 2 lights\n", " left: "})
        EXPECT_THAT(result.err, HasSubstr(step));
}

/// Killed after some steps, by a signal that nobody can catch.
TEST(Compare, FinishedStepsAreFoundByTheNextRun) {
    const TemporaryFolder folder, cache;
    const std::map<std::string, std::string> environment{{"XDG_CACHE_HOME", cache.path}};
    const auto compare = [&](const char* frames) {
        return std::vector<std::string>{"compare",
                                        "spheres",
                                        "--size",
                                        "64x36",
                                        "--lights",
                                        "3",
                                        "--light-counts",
                                        "1,2",
                                        "--frames",
                                        frames,
                                        "--frame-limit",
                                        "1000",
                                        "--renderers",
                                        "light-prepass,deferred@light-culling=volumes",
                                        "-o",
                                        "report"};
    };
    const auto kept = [&] { // the steps of one report
        for (std::error_code none; const auto& entry : fs::directory_iterator(cache.path / "prelight/compare", none))
            return bytes_of(entry.path() / "steps");
        return std::string();
    };
    const auto killed_when = [&](const std::vector<std::string>& arguments, const char* step) {
        Prelight program(arguments, folder.path, environment, {.seconds = 240});
        while (program.running() && kept().find(step) == std::string::npos)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        program.send(SIGKILL);
        return program.wait();
    };
    EXPECT_EQ(killed_when(compare("3"), "picture of light-prepass").signal, SIGKILL);
    for (const auto& entry : fs::directory_iterator(folder.path)) // what a kill leaves goes with the test's folder
        fs::remove_all(entry.path());
    const Result other =
        run(small_comparison({"--light-counts", "none", "--renderers", "light-prepass", "-o", "report"}), folder.path,
            {}, environment);
    ASSERT_TRUE(succeeded(other));
    EXPECT_THAT(other.err, testing::Not(HasSubstr("finished steps"))) << "other arguments";
    EXPECT_EQ(killed_when(compare("3"), "times of 1").signal, SIGKILL);
    for (const auto& entry : fs::directory_iterator(folder.path))
        fs::remove_all(entry.path());
    const Result result = run(compare("3"), folder.path, {.seconds = 240}, environment);
    ASSERT_TRUE(succeeded(result));
    EXPECT_THAT(result.err, HasSubstr("finished steps of an earlier run found"));
    const Json json = report_of(folder.path / "report");
    ASSERT_EQ(json.at("runs").size(), 2u);
    for (const Json& run : json.at("runs")) {
        ASSERT_TRUE(run.at("error").is_null());
        expect_stats(run);
        EXPECT_GT(run.at("light_pixel_pairs").at("contributing"), 0);
        EXPECT_GT(run.at("difference").at("psnr"), 40);
        for (const auto& [view, file] : run.at("pictures").items())
            EXPECT_EQ(load_png(folder.path / "report" / file.get<std::string>()).width, 64u) << view;
    }
    for (const Json& line : json.at("light_counts"))
        EXPECT_EQ(line.at("points").size(), 3u);
    EXPECT_TRUE(fs::is_empty(cache.path / "prelight/compare")) << "a report that is there needs no steps";
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Compare, InterruptLeavesTheEarlierReportAndNothingHalf) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(
        small_comparison({"--light-counts", "none", "--renderers", "light-prepass", "-o", "report"}), folder.path)));
    const std::string before = bytes_of(folder.path / "report/report.json");
    for (const int signal : {SIGINT, SIGTERM}) {
        Prelight program({"compare", "spheres", "--size", "64x36", "--frames", "100000000", "--frame-limit", "100000",
                          "-o", "report"},
                         folder.path);
        const auto half = [&] { // pictures lie there, under another name
            for (const auto& entry : fs::directory_iterator(folder.path)) {
                const fs::path pictures = entry.path() / "pictures"; // made a moment after its folder
                if (entry.path().filename() != "report" && fs::exists(pictures) && !fs::is_empty(pictures))
                    return true;
            }
            return false;
        };
        while (program.running() && !half())
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ASSERT_TRUE(program.running()) << program.wait().err;
        program.send(signal);
        const Result result = program.wait();
        EXPECT_EQ(result.signal, signal);
        EXPECT_FALSE(result.timed_out);
        EXPECT_EQ(folder.entries(), 1u);
        EXPECT_EQ(bytes_of(folder.path / "report/report.json"), before);
    }
}

} // namespace
} // namespace prelight::test
