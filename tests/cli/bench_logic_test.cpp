// What `prelight bench SCENE` makes of its figures: which pass is what, what is noise, which runs match,
// and how far a light pass is from its limit.
#include <bench_scene/baseline.hpp>
#include <bench_scene/limit.hpp>
#include <bench_scene/pass_kind.hpp>
#include <gmock/gmock.h>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

Spread steady(double ms) { return {ms, ms, ms}; }

TEST(PassKind, GoesByTheBeginningOfTheName) {
    for (const char* name : {"depth", "depth-normal", "normal", "geometry"})
        EXPECT_EQ(kind_of(name), PassKind::geometry) << name;
    for (const char* name : {"depth-range", "light-lists coarse", "light-lists", "light-lists-fill", "tile-lists"})
        EXPECT_EQ(kind_of(name), PassKind::lists) << name;
    for (const char* name : {"light", "light-ambient", "light tiles"})
        EXPECT_EQ(kind_of(name), PassKind::light) << name;
    EXPECT_EQ(kind_of("material"), PassKind::material);
    for (const char* name : {"tonemap", "resolve"})
        EXPECT_EQ(kind_of(name), PassKind::display) << name;
    for (const char* name : {"lights", "ambient", "opaque", "plain-forward"})
        EXPECT_EQ(kind_of(name), PassKind::other) << name;
}

TEST(PassKind, SumsWhatIsThere) {
    Stats stats;
    stats.passes = {{.name = "light-lists count", .gpu_ms = steady(2)},
                    {.name = "light-lists fill", .gpu_ms = steady(3)},
                    {.name = "light", .gpu_ms = steady(50)}};
    EXPECT_EQ(passes_ms(stats, PassKind::lists, false), 5);
    EXPECT_EQ(passes_ms(stats, PassKind::light, false), 50);
    EXPECT_EQ(passes_ms(stats, PassKind::material, false), std::nullopt);
    EXPECT_EQ(passes_ms(stats, PassKind::light, true), std::nullopt) << "no pass has its CPU time";
    for (PassStats& pass : stats.passes)
        pass.cpu_ms = steady(1.5 * pass.gpu_ms.median);
    EXPECT_EQ(passes_ms(stats, PassKind::lists, true), 7.5);
}

TEST(Noise, IsTheWayFromTheFastestFrameToTheMedian) {
    EXPECT_DOUBLE_EQ(figure_of({80, 100, 900}).noise, 20) << "a slow frame says nothing";
    EXPECT_DOUBLE_EQ(figure_of({99.9, 100, 100}).noise, 2) << "nothing is steadier than 2 %";
    const Figure ratio = Figure{200, 20} / Figure{50, 10};
    EXPECT_DOUBLE_EQ(ratio.value, 4);
    EXPECT_DOUBLE_EQ(ratio.noise, 4 * (0.1 + 0.2));
}

TEST(Noise, JudgesBySpreadsOfBoth) {
    EXPECT_EQ(judge({100, 6}, {111, 6}, 9, 9), Judgement::within);
    EXPECT_EQ(judge({100, 6}, {113, 6}, 9, 9), Judgement::beyond);
    EXPECT_EQ(judge({113, 6}, {100, 6}, 9, 9), Judgement::beyond);
    EXPECT_EQ(judge({100, 0}, {300, 0}, 9, 4), Judgement::unknown) << "four frames have no spread to speak of";
    EXPECT_EQ(judge({100, 0}, {300, 0}, 5, 5), Judgement::beyond);
}

SavedRun a_run() {
    return {.variant = "light-prepass",
            .renderer = "light-prepass",
            .scene = "city",
            .shading = "ggx",
            .device = "d",
            .settings = {{"normals", "oct24"}, {"light-culling", "tiles"}},
            .width = 64,
            .height = 36,
            .frames = 9,
            .lights = 16,
            .wall_ms = steady(50),
            .cpu_ms = steady(100),
            .gpu_ms = steady(40)};
}

TEST(Baseline, MatchesWhatWasAskedFor) {
    const SavedRun run = a_run();
    EXPECT_TRUE(same_work(run, run));
    SavedRun other = run;
    other.settings["light-culling"] = "volumes"; // another default
    EXPECT_TRUE(same_work(run, other));
    const auto differs = [&](auto change) {
        SavedRun changed = run;
        change(changed);
        return !same_work(run, changed) && !same_work(changed, run);
    };
    EXPECT_TRUE(differs([](SavedRun& r) { r.variant += "@normals=oct32"; }));
    EXPECT_TRUE(differs([](SavedRun& r) { r.renderer = "deferred"; }));
    EXPECT_TRUE(differs([](SavedRun& r) { r.lights = 17; }));
    EXPECT_TRUE(differs([](SavedRun& r) { r.width = 65; }));
    EXPECT_TRUE(differs([](SavedRun& r) { r.height = 35; }));
    EXPECT_TRUE(differs([](SavedRun& r) { r.scene = "lights"; }));
    EXPECT_TRUE(differs([](SavedRun& r) { r.shading = "phong"; }));
    EXPECT_TRUE(differs([](SavedRun& r) { r.preset = "engel"; }));
}

TEST(Baseline, MatchesSettingsWhereAFileDoesNotSayWhatWasAskedFor) {
    SavedRun run = a_run(), bare = a_run();
    bare.variant.clear();
    EXPECT_TRUE(same_work(run, bare));
    bare.settings.erase("normals"); // an older version knows less
    EXPECT_TRUE(same_work(run, bare));
    bare.settings["light-culling"] = "volumes";
    EXPECT_FALSE(same_work(run, bare));
    EXPECT_FALSE(same_work(bare, run));
}

TEST(Baseline, FindsAFileWhereverItLies) {
    SavedRun run = a_run(), other = a_run();
    run.scene = "a/helmet.glb";
    other.scene = "helmet.glb";
    EXPECT_TRUE(same_work(run, other));
}

const Change& change_of(const std::vector<Change>& changes, const std::string& figure) {
    for (const Change& change : changes)
        if (change.figure == figure)
            return change;
    throw Error(figure + ": is not there");
}

TEST(Baseline, TellsAChangeFromNoiseAndCountsExactly) {
    SavedRun before = a_run(), after = a_run(), unit_before = a_run(), unit_after = a_run();
    before.cpu_ms = {95, 100, 130};
    after.cpu_ms = {190, 200, 260};
    unit_before.cpu_ms = {19, 20, 24};
    unit_after.cpu_ms = {38, 40, 47}; // the whole machine was half as fast
    before.pairs_evaluated = 1000;
    after.pairs_evaluated = 1001;
    const auto changes = changes_of(before, &unit_before, after, &unit_after);
    EXPECT_EQ(change_of(changes, "CPU ms").verdict, Judgement::unit_changed);
    EXPECT_EQ(change_of(changes, "CPU ms").difference(), "+100.0 %");
    EXPECT_EQ(change_of(changes, "F, CPU ms").verdict, Judgement::beyond);
    EXPECT_EQ(change_of(changes, "CPU, in F").verdict, Judgement::within);
    EXPECT_DOUBLE_EQ(change_of(changes, "CPU, in F").after, 5);
    EXPECT_EQ(change_of(changes, "wall ms").verdict, Judgement::within);
    EXPECT_TRUE(change_of(changes, "pairs evaluated").counted);
    EXPECT_EQ(change_of(changes, "pairs evaluated").after, 1001);
    EXPECT_EQ(change_of(changes, "device bytes").difference(), "0 %");
    const auto without = changes_of(before, nullptr, after, &unit_after);
    EXPECT_EQ(change_of(without, "CPU ms").verdict, Judgement::beyond);
    EXPECT_THROW(change_of(without, "CPU, in F"), Error);
}

TEST(Baseline, ComparesCountsAloneAcrossDevices) {
    SavedRun before = a_run(), after = a_run();
    after.device = "another";
    const auto changes = changes_of(before, nullptr, after, nullptr);
    EXPECT_EQ(changes.size(), 4u);
    for (const Change& change : changes)
        EXPECT_TRUE(change.counted) << change.figure;
}

Json saved_run() {
    const Json spread = {{"min", 1.0}, {"median", 2.0}, {"max", 3.0}};
    return {{"renderer", "deferred"},
            {"scene", "city"},
            {"settings", {{"model", "full"}}},
            {"size", {64, 36}},
            {"msaa", 1},
            {"frames", 5},
            {"lights", 16},
            {"wall_ms", spread},
            {"cpu_ms", spread},
            {"gpu_ms", spread},
            {"passes", {{{"name", "light"}, {"gpu_ms", spread}, {"cpu_ms", nullptr}}}},
            {"attachment_bytes", 1},
            {"device_bytes", 2},
            {"light_pixel_pairs", {{"evaluated", 3}, {"contributing", 4}}}};
}

TEST(SavedBench, ReadsWhatStatsWritesToo) {
    const SavedBench bench = saved_bench({{"runs", {saved_run()}}}, "f");
    ASSERT_EQ(bench.runs.size(), 1u);
    EXPECT_EQ(bench.runs[0].settings.at("model"), "full");
    EXPECT_EQ(bench.runs[0].cpu_ms.max, 3);
    EXPECT_EQ(bench.runs[0].passes[0].name, "light");
    EXPECT_EQ(bench.runs[0].passes[0].cpu_ms, std::nullopt);
    EXPECT_EQ(bench.runs[0].pairs_contributing, 4u);
}

TEST(SavedBench, SaysWhatIsNotAsItShouldBe) {
    const auto message = [](const Json& json) -> std::string {
        try {
            saved_bench(json, "f");
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(message(Json::array()), "f: is no object");
    EXPECT_THAT(message({{"bench", "encodings"}}), HasSubstr("f: holds no figures"));
    EXPECT_THAT(message({{"runs", 3}}), HasSubstr("no list"));
    EXPECT_THAT(message({{"runs", Json::array()}}), HasSubstr("there is none"));
    EXPECT_THAT(message({{"runs", {7}}}), HasSubstr("f: runs[0]: is no object"));
    const Json whole = saved_run();
    for (const auto& [key, value] : whole.items()) {
        Json without = saved_run();
        without.erase(key);
        EXPECT_THAT(message({{"runs", {without}}}), HasSubstr("f: runs[0]")) << key;
        Json wrong = saved_run();
        wrong[key] = true;
        EXPECT_THAT(message({{"runs", {wrong}}}), HasSubstr("f: runs[0]")) << key;
    }
    Json run = saved_run();
    run["cpu_ms"]["min"] = 5;
    EXPECT_THAT(message({{"runs", {run}}}), HasSubstr("cpu_ms: is not in the order"));
    run = saved_run();
    run["lights"] = -1;
    EXPECT_THAT(message({{"runs", {run}}}), HasSubstr("lights: is no whole number"));
    EXPECT_THAT(message({{"runs", {saved_run()}}, {"limit", 1}}), HasSubstr("limit"));
    EXPECT_THAT(message({{"runs", {saved_run()}}, {"limit", {{"figures", {1}}, {"runs", Json::array()}}}}),
                HasSubstr("figures[0]"));
    const Json figures = {{"variant", "a"}, {"lights", 1}, {"unit_ms", 1.0}, {"frame_in_f", 2.0}, {"frames_by", "sun"}};
    EXPECT_THAT(message({{"runs", {saved_run()}}, {"limit", {{"figures", {figures}}, {"runs", Json::array()}}}}),
                HasSubstr("frames_by: is no clock"));
    EXPECT_THAT(message({{"runs", {saved_run()}}, {"baseline", {{"file", "b"}, {"runs", {1}}}}}),
                HasSubstr("f: baseline: runs[0]: is no object"));
}

/// Jobs and figures as if a light pass had been measured with its limits.
struct Limits : testing::Test {
    Limits() {
        const auto lists = [](const char* made, const char* size) {
            return std::map<std::string, std::string>{
                {"light-culling", "tiles"}, {"light-lists", made}, {"tile-size", size}};
        };
        jobs = {{.variant = {.renderer = "light-prepass"}},
                {.variant = {.renderer = "plain-forward"}, .role = Role::unit},
                {.variant = {.renderer = "light-prepass"}, .role = Role::no_lights},
                {.variant = {.renderer = "light-prepass", .settings = lists("perfect", "8")},
                 .role = Role::perfect,
                 .tile = 8},
                {.variant = {.renderer = "light-prepass", .settings = lists("perfect", "16")},
                 .role = Role::perfect,
                 .tile = 16},
                {.variant = {.renderer = "light-prepass", .settings = lists("empty", "16")},
                 .role = Role::empty,
                 .tile = 16},
                {.variant = {.renderer = "deferred", .settings = lists("perfect", "32")},
                 .role = Role::perfect,
                 .tile = 32}};
        add(0, 200, {{"depth-normal", 40}, {"light-lists fill", 6}, {"light", 60}, {"material", 35}, {"tonemap", 5}});
        add(1, 40, {{"plain-forward", 30}});
        add(2, 90, {{"depth-normal", 40}, {"light", 1}, {"material", 35}});
        add(3, 150, {{"light", 48}});
        add(4, 150, {{"light", 50}});
        add(5, 100, {{"light", 3}});
        add(6, 100, {{"light", 1}}); // another renderer's
    }

    void add(size_t job, double cpu_ms, std::vector<std::pair<std::string, double>> passes) {
        app::Run run{.job = &jobs[job], .stop = {.count = 16, .lights = 16}};
        run.stats.cpu_ms = steady(cpu_ms);
        run.stats.gpu_ms = steady(cpu_ms / 2);
        for (const auto& [name, ms] : passes)
            run.stats.passes.push_back({.name = name, .gpu_ms = steady(ms)});
        measured.runs.push_back(std::move(run));
    }

    std::vector<Job> jobs;
    Measured measured;
    std::vector<std::string> missing;
};

TEST_F(Limits, AreRatiosOfTheContendersOwn) {
    const auto figures = limit_figures(measured, jobs, true, missing);
    ASSERT_EQ(figures.size(), 1u);
    const LimitFigures& f = figures[0];
    EXPECT_DOUBLE_EQ(f.frame_in_f(), 5);
    EXPECT_DOUBLE_EQ(*f.no_lights_in_f(), 90.0 / 40);
    EXPECT_FALSE(f.passes_by_cpu);
    EXPECT_DOUBLE_EQ(*f.geometry_in_f(), 75.0 / 30);
    EXPECT_EQ(f.perfect_tile, 8u);
    EXPECT_DOUBLE_EQ(*f.light_over_limit(), 60.0 / 48);
    EXPECT_DOUBLE_EQ(*f.lists_over_light(), 0.1);
    EXPECT_DOUBLE_EQ(*f.empty_ms, 3);
}

TEST_F(Limits, TakeNoListsThatLackLight) {
    for (app::Run& run : measured.runs)
        run.stats.pairs_contributing = 10'000;
    measured.runs[3].stats.pairs_contributing = 9'000; // the faster of the two
    measured.runs[4].stats.pairs_contributing = 9'995; // edges
    const auto figures = limit_figures(measured, jobs, true, missing);
    EXPECT_EQ(figures.at(0).perfect_tile, 16u);
    ASSERT_EQ(missing.size(), 1u);
    EXPECT_THAT(missing[0], HasSubstr("tiles of 8, 16 lights: the lists hold 0.01 of 0.01 million"));
}

TEST_F(Limits, GoByDeviceTimeOnAGpu) {
    const auto figures = limit_figures(measured, jobs, false, missing);
    EXPECT_DOUBLE_EQ(figures.at(0).frame_ms, 100);
    EXPECT_DOUBLE_EQ(figures.at(0).frame_in_f(), 5);
    EXPECT_FALSE(figures.at(0).by_cpu);
}

TEST_F(Limits, TakeThePassesCpuTimeWhereAllHaveIt) {
    for (app::Run& run : measured.runs)
        for (PassStats& pass : run.stats.passes)
            pass.cpu_ms = steady(pass.name == "light" ? 3 * pass.gpu_ms.median : 2 * pass.gpu_ms.median);
    const auto figures = limit_figures(measured, jobs, true, missing);
    EXPECT_TRUE(figures.at(0).passes_by_cpu);
    EXPECT_DOUBLE_EQ(*figures.at(0).light_ms, 180);
    EXPECT_DOUBLE_EQ(*figures.at(0).lists_over_light(), 12.0 / 180);
    EXPECT_DOUBLE_EQ(*figures.at(0).geometry_in_f(), 2.5);
}

TEST_F(Limits, LeavesGeometryOutWhereAPassLightsToo) {
    measured.runs[0].stats.passes.push_back({.name = "opaque", .gpu_ms = steady(1)});
    EXPECT_EQ(limit_figures(measured, jobs, true, missing).at(0).geometry_in_f(), std::nullopt);
}

TEST_F(Limits, InventNothingThatWasNotMeasured) {
    std::erase_if(measured.runs, [](const app::Run& run) {
        return run.job->role == Role::perfect || run.job->role == Role::no_lights;
    });
    const auto figures = limit_figures(measured, jobs, true, missing);
    EXPECT_EQ(figures.at(0).light_over_limit(), std::nullopt);
    EXPECT_EQ(figures.at(0).no_lights_in_f(), std::nullopt);
    jobs.erase(jobs.begin() + 1); // without F there is no unit
    EXPECT_TRUE(limit_figures(measured, jobs, true, missing).empty());
}

} // namespace
} // namespace prelight::app
