// `prelight bench SCENE` and `bench report`: tables, files, and what they refuse.
#include "files.hpp"
#include "process.hpp"
#include "spread.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

namespace prelight::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;
namespace fs = std::filesystem;

std::vector<std::string> small_bench(const std::vector<std::string>& more) {
    return joined({"bench", "lights", "--size", "96x54", "--frames", "2", "--device", "cpu"}, more);
}

/// Measured once for all: two contenders at two numbers of lights with their limits.
class BenchScene : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        // Numbers of lights in any order, one of them twice.
        result_ = new Result(run(small_bench({"--light-counts", "64,16,64", "--limit", "--set", "normals=oct32",
                                              "--json", "first.json", "--validate"}),
                                 folder_->path));
        if (result_->status == 0)
            json_ = new Json(Json::parse(bytes_of(folder_->path / "first.json")));
    }
    static void TearDownTestSuite() {
        delete json_;
        delete result_;
        delete folder_;
    }
    void SetUp() override { ASSERT_TRUE(succeeded(*result_) && json_); }
    static const Json& json() { return *json_; }

    static inline TemporaryFolder* folder_ = nullptr;
    static inline Result* result_ = nullptr;
    static inline Json* json_ = nullptr;
};

TEST_F(BenchScene, WritesEachRunAsStatsDoes) {
    EXPECT_EQ(json().at("scene"), "lights");
    EXPECT_EQ(json().at("frames"), 2);
    const Json& runs = json().at("runs");
    ASSERT_EQ(runs.size(), 4u);
    std::vector<std::pair<std::string, int>> order;
    for (const Json& run : runs) {
        order.emplace_back(run.at("variant"), run.at("lights"));
        EXPECT_EQ(run.at("light_count"), run.at("lights"));
        EXPECT_EQ(run.at("size"), Json({96, 54}));
        EXPECT_EQ(run.at("frames"), 2);
        EXPECT_EQ(run.at("shading"), "ggx");
        EXPECT_TRUE(run.at("preset").is_null());
        for (const char* time : {"wall_ms", "cpu_ms", "gpu_ms"}) {
            expect_spread(run.at(time));
            EXPECT_GT(run.at(time).at("min"), 0);
        }
        ASSERT_GE(run.at("passes").size(), 2u);
        for (const Json& pass : run.at("passes")) {
            expect_spread(pass.at("gpu_ms"));
            expect_spread(pass.at("cpu_ms"));
            EXPECT_NE(pass.at("kind"), "other") << pass;
        }
        EXPECT_GE(run.at("attachment_bytes"), 96 * 54 * 8);
        EXPECT_GT(run.at("device_bytes"), run.at("attachment_bytes"));
        EXPECT_GT(run.at("light_pixel_pairs").at("contributing"), 0) << "counted in a frame of its own";
        EXPECT_GE(run.at("light_pixel_pairs").at("evaluated"), run.at("light_pixel_pairs").at("contributing"));
    }
    EXPECT_THAT(order, testing::ElementsAre(std::pair("light-prepass@normals=oct32", 16), std::pair("deferred", 16),
                                            std::pair("light-prepass@normals=oct32", 64), std::pair("deferred", 64)));
    EXPECT_EQ(runs[0].at("settings").at("normals"), "oct32");
}

TEST_F(BenchScene, PrintsATableOfThem) {
    EXPECT_THAT(result_->out, HasSubstr("lights, 96x54"));
    for (const char* text : {"\n16 lights ", "\n64 lights ", "\nlight-prepass@normals=oct32 ", "\ndeferred ", "CPU ms",
                             "limit, 16 lights: F is ", "limit, 64 lights: F is "})
        EXPECT_THAT(result_->out, HasSubstr(text));
}

TEST_F(BenchScene, GivesFramesInUnitsOfF) {
    const Json& limit = json().at("limit");
    std::map<std::string, int> roles;
    for (const Json& run : limit.at("runs")) {
        ++roles[run.at("role")];
        if (run.at("role") == "plain-forward") {
            EXPECT_EQ(run.at("frames"), 6) << "F is measured more often";
            EXPECT_EQ(run.at("lights"), 0) << "not even the host looks at lights";
            EXPECT_EQ(run.at("at_lights"), run.at("light_count"));
            EXPECT_EQ(run.at("passes").size(), 1u) << "one pass and no other";
            EXPECT_LT(run.at("draws"), 266) << "what is out of view is not drawn";
            EXPECT_GT(run.at("draws"), 100);
        }
        if (run.at("role") == "no-lights") {
            EXPECT_EQ(run.at("lights"), 0);
        }
    }
    EXPECT_EQ(roles["plain-forward"], 2);
    EXPECT_EQ(roles["no-lights"], 4);
    ASSERT_EQ(limit.at("figures").size(), 4u);
    for (const Json& figures : limit.at("figures")) {
        EXPECT_EQ(figures.at("frames_by"), "cpu_ms");
        EXPECT_EQ(figures.at("passes_by"), "cpu_ms");
        EXPECT_NEAR(figures.at("frame_in_f"), double(figures.at("frame_ms")) / double(figures.at("unit_ms")), 1e-9);
        EXPECT_NEAR(figures.at("geometry_in_f"), double(figures.at("geometry_ms")) / double(figures.at("unit_pass_ms")),
                    1e-9);
        EXPECT_GT(figures.at("light_ms"), 0);
        EXPECT_EQ(figures.at("perfect_ms").is_null(), figures.at("light_over_limit").is_null());
    }
}

TEST_F(BenchScene, HasPerfectAndEmptyListsWhereTheRendererDoes) {
    const bool offered = json().at("runs")[0].at("settings").contains("light-lists");
    const Json& missing = json().at("limit").at("missing");
    std::map<std::string, std::set<std::string>> tiles;
    for (const Json& run : json().at("limit").at("runs"))
        if (run.at("role") == "perfect-lists" || run.at("role") == "empty-lists")
            tiles[run.at("role")].insert(run.at("settings").at("tile-size"));
    if (!offered) {
        ASSERT_EQ(missing.size(), 2u);
        EXPECT_THAT(missing[0].get<std::string>(), HasSubstr("no setting light-lists"));
        EXPECT_TRUE(tiles.empty());
        return;
    }
    EXPECT_TRUE(missing.empty()) << missing;
    for (const char* role : {"perfect-lists", "empty-lists"})
        for (const char* size : {"8", "16", "32"})
            EXPECT_TRUE(tiles[role].contains(size)) << role << " " << size;
    for (const Json& run : json().at("limit").at("runs"))
        if (run.at("role") == "empty-lists") {
            EXPECT_EQ(run.at("light_pixel_pairs").at("evaluated"), 0);
        }
    for (const Json& figures : json().at("limit").at("figures"))
        EXPECT_GT(figures.at("light_over_limit"), 0);
}

TEST_F(BenchScene, PrintsTheChangeSinceABaseline) {
    const fs::path& place = folder_->path;
    const Result result = run(small_bench({"--light-counts", "16,32", "--renderers", "light-prepass@normals=oct32",
                                           "--baseline", "first.json", "--json", "second.json"}),
                              place);
    ASSERT_TRUE(succeeded(result));
    EXPECT_THAT(result.out, HasSubstr("against first.json"));
    EXPECT_THAT(result.out, HasSubstr("\nlight-prepass@normals=oct32, 32 lights: not in it"));
    EXPECT_THAT(result.out, HasSubstr("too few frames to tell"));
    const Json second = Json::parse(bytes_of(place / "second.json"));
    const Json& changed = second.at("baseline").at("runs");
    ASSERT_EQ(changed.size(), 1u);
    std::map<std::string, Json> changes;
    for (const Json& change : changed[0].at("changes"))
        changes[change.at("figure")] = change;
    EXPECT_EQ(changes.at("pairs evaluated").at("verdict"), "the same") << "the same work";
    EXPECT_EQ(changes.at("attachment bytes").at("verdict"), "the same");
    EXPECT_EQ(changes.at("CPU ms").at("before"), json().at("runs")[0].at("cpu_ms").at("median"));
    EXPECT_FALSE(changes.contains("CPU, in F")) << "this run has no F";
}

TEST_F(BenchScene, ABrowserShowsThePageWithoutAComplaint) {
    const fs::path& place = folder_->path;
    // A name that would end or confuse a page that did not take care of it.
    const std::string awkward = "x<!--<script>&amp;'\".json";
    fs::copy_file(place / "first.json", place / awkward);
    ASSERT_TRUE(succeeded(run({"bench", "report", "first.json", awkward, "-o", "page.html"}, place)));
    EXPECT_THAT(bytes_of(place / "page.html"), Not(HasSubstr("{{")));
    // One number of lights alone: a page without a chart.
    Json one = json();
    const Json lights = one.at("runs")[0].at("lights");
    std::erase_if(one.at("runs").get_ref<Json::array_t&>(),
                  [&](const Json& run) { return run.at("lights") != lights; });
    one.erase("limit");
    std::ofstream(place / "one.json") << one;
    ASSERT_TRUE(succeeded(run({"bench", "report", "one.json", "-o", "one.html"}, place)));
    for (const char* program : {"node", "chromium"})
        if (std::system(fmt::format("{} --version > /dev/null 2>&1", program).c_str()) != 0)
            GTEST_SKIP() << program << " is missing";
    const char* shots = std::getenv("PRELIGHT_TEST_PICTURES");
    for (const char* page : {"page.html", "one.html"}) {
        const std::string command = fmt::format(
            "timeout -k 5 120 node '{}/tests/page/bench.js' '{}' {} > '{}' 2>&1", PRELIGHT_SOURCE_DIR,
            (place / page).string(), shots ? fmt::format("'{}/{}'", shots, page) : "", (place / "said").string());
        EXPECT_EQ(std::system(command.c_str()), 0) << page << ": " << bytes_of(place / "said");
    }
}

TEST(BenchSceneFailure, IsOneLineAndLeavesNothing) {
    const TemporaryFolder folder;
    EXPECT_TRUE(failed_with(run(small_bench({"--json", "missing/a.json"}), folder.path), 1));
    EXPECT_TRUE(failed_with(run({"bench", "missing.glb", "--json", "a.json"}, folder.path), 1));
    EXPECT_TRUE(failed_with(run(small_bench({"--baseline", "missing.json", "--json", "a.json"}), folder.path), 1));
    EXPECT_TRUE(failed_with(run({"bench", "report", "missing.json", "-o", "a.html"}, folder.path), 1));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(BenchSceneFailure, NamesTheFileThatHoldsNoFigures) {
    const TemporaryFolder folder;
    for (const auto& [name, text] : {std::pair("broken.json", "{\"runs\": [{"), std::pair("foreign.json", "{\"a\": 1}"),
                                     std::pair("list.json", "[1, 2]"), std::pair("empty.json", ""),
                                     std::pair("part.json", "{\"runs\": [{\"renderer\": \"deferred\"}]}")}) {
        std::ofstream(folder.path / name) << text;
        for (const Result& result : {run(small_bench({"--baseline", name, "--json", "a.json"}), folder.path),
                                     run({"bench", "report", name, "-o", "a.html"}, folder.path)}) {
            EXPECT_TRUE(failed_with(result, 1)) << name;
            EXPECT_THAT(result.err, HasSubstr(std::string("prelight: ") + name + ": "));
        }
    }
    EXPECT_FALSE(fs::exists(folder.path / "a.json"));
    EXPECT_FALSE(fs::exists(folder.path / "a.html"));
}

TEST(BenchSceneFailure, AnUnwritablePageIsToldFirst) {
    const TemporaryFolder folder;
    EXPECT_TRUE(failed_with(run({"bench", "report", "a.json", "-o", "missing/a.html"}, folder.path), 1));
    fs::create_directory(folder.path / "b.html");
    EXPECT_TRUE(failed_with(run({"bench", "report", "a.json", "-o", "b.html"}, folder.path), 1));
}

} // namespace
} // namespace prelight::test
