// What long commands have when they are cut short: by Ctrl-C, or by --budget.
#include "files.hpp"
#include "process.hpp"

#include <csignal>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;
namespace fs = std::filesystem;

std::vector<std::string> bench_of_lights(const std::vector<std::string>& more) {
    return joined(
        {"bench", "lights", "--size", "64x36", "--device", "cpu", "--renderers", "deferred", "--json", "a.json"}, more);
}

TEST(PartialBench, KeepsEachNumberOfLightsAsItComes) {
    const TemporaryFolder folder;
    Prelight program({"bench", "lights", "--size", "16x9", "--device", "cpu", "--renderers", "deferred",
                      "--light-counts", "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16", "--frames", "100", "--json",
                      "b.json"},
                     folder.path);
    ASSERT_TRUE(eventually([&] { return fs::exists(folder.path / "b.json") || !program.running(); }));
    program.send(SIGINT);
    const Result result = program.wait();
    const Json json = Json::parse(bytes_of(folder.path / "b.json"));
    ASSERT_GE(json.at("runs").size(), 1u);
    EXPECT_EQ(json.at("runs").at(0).at("frames"), 100);
    EXPECT_TRUE(json.at("budget").is_null());
    if (result.signal == SIGINT) { // it may have come to its end
        EXPECT_EQ(json.at("complete"), false);
        EXPECT_LT(json.at("runs").size(), 16u);
        EXPECT_THAT(result.out, HasSubstr("\n1 light ")) << "printed when it was there";
    }
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Budget, CutsFramesAndNumbersOfLights) {
    const TemporaryFolder folder;
    const Result result =
        run(bench_of_lights({"--light-counts", "1,65536", "--frames", "100000", "--budget", "3"}), folder.path);
    ASSERT_TRUE(succeeded(result));
    const Json json = Json::parse(bytes_of(folder.path / "a.json"));
    EXPECT_EQ(json.at("complete"), true);
    const Json& budget = json.at("budget");
    EXPECT_EQ(budget.at("seconds"), 3);
    EXPECT_EQ(budget.at("frames_asked_for"), 100000);
    ASSERT_GE(budget.at("frames").size(), 1u);
    const int frames = budget.at("frames").at(0).at("frames");
    EXPECT_GE(frames, 1);
    EXPECT_LT(frames, 100000);
    EXPECT_EQ(json.at("runs").at(0).at("frames"), frames);
    EXPECT_EQ(json.at("runs").size() + budget.at("lights_left_out").size(), 2u);
    EXPECT_THAT(result.out, HasSubstr("\n--budget 3: "));
    // Far below what was asked for, which would be an hour; machines differ.
    EXPECT_LT(budget.at("spent_seconds"), 40);
}

TEST(Budget, IsNullAndSilentWhereAllFits) {
    const TemporaryFolder folder;
    const Result result =
        run(bench_of_lights({"--light-counts", "1", "--frames", "2", "--budget", "1e6"}), folder.path);
    ASSERT_TRUE(succeeded(result));
    const Json json = Json::parse(bytes_of(folder.path / "a.json"));
    EXPECT_EQ(json.at("budget").at("frames").at(0).at("frames"), 2);
    EXPECT_TRUE(json.at("budget").at("lights_left_out").empty());
    EXPECT_THAT(result.out, testing::Not(HasSubstr("--budget")));
    EXPECT_TRUE(failed_with(run(bench_of_lights({"--budget", "0"}), folder.path), 2));
    EXPECT_TRUE(failed_with(run({"bench", "encodings", "--budget", "3"}, folder.path), 2));
}

TEST(Budget, OfCompareCutsItsTimes) {
    const TemporaryFolder folder;
    const Result result =
        run({"compare", "lights", "--lights", "2", "--size", "32x18", "--device", "cpu", "--renderers", "deferred",
             "--light-counts", "4,8", "--frames", "3", "--budget", "0.01", "-o", "out"},
            folder.path);
    ASSERT_TRUE(succeeded(result));
    EXPECT_THAT(result.out, HasSubstr("deferred: ")) << "each picture's difference";
    EXPECT_THAT(result.out, HasSubstr("2 lights: deferred ")) << "each number's times";
    EXPECT_THAT(result.out, HasSubstr("--budget 0.01: 8 lights left out"));
    const Json json = Json::parse(bytes_of(folder.path / "out" / "report.json"));
    EXPECT_EQ(json.at("budget").at("seconds"), 0.01);
    EXPECT_EQ(json.at("budget").at("cut"),
              Json({"1 of 3 frames at 2 lights", "4 lights left out", "8 lights left out"}));
}

} // namespace
} // namespace prelight::test
