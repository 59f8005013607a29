// `prelight sequence`: every frame has the bytes that `render --time` gives it, in whatever company it is drawn.
#include "files.hpp"
#include "process.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <prelight/image.hpp>
#include <sequence/scene_at_time.hpp>
#include <sequence/sequence_stats.hpp>

namespace prelight::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Files of the folder that do not begin with a dot, by name.
std::set<std::string> visible(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (!entry.path().filename().string().starts_with('.'))
            names.insert(entry.path().filename());
    return names;
}

struct Way {
    const char* name;
    Words options;
};
void PrintTo(const Way& way, std::ostream* stream) { *stream << way.name; }

class SequenceBytes : public testing::TestWithParam<Way> {};

/// Frames back and forth in time, so that whatever stays from the frame before would show.
TEST_P(SequenceBytes, AreThoseOfRender) {
    const TemporaryFolder folder;
    const Words options = joined({"--size", "96x54"}, GetParam().options);
    ASSERT_TRUE(succeeded(run(joined({"sequence", "motion", "--fps", "3", "--frames-at", "7,0-4x2,1", "-o", "s.##.png",
                                      "--view", "depth=d.##.png", "--validate", "--msaa", "1"},
                                     options),
                              folder.path)));
    EXPECT_THAT(visible(folder.path), ElementsAre("d.00.png", "d.01.png", "d.02.png", "d.04.png", "d.07.png",
                                                  "s.00.png", "s.01.png", "s.02.png", "s.04.png", "s.07.png"));
    for (const int frame : {2, 1}) {
        SCOPED_TRACE(frame);
        ASSERT_TRUE(succeeded(run(joined({"render", "motion", "--time", fmt::format("{}", frame / 3.0), "-o", "r.png",
                                          "--view", "depth=rd.png", "--msaa", "1"},
                                         options),
                                  folder.path)));
        EXPECT_TRUE(bytes_of(folder.path / fmt::format("s.0{}.png", frame)) == bytes_of(folder.path / "r.png"));
        EXPECT_TRUE(bytes_of(folder.path / fmt::format("d.0{}.png", frame)) == bytes_of(folder.path / "rd.png"));
    }
    EXPECT_FALSE(bytes_of(folder.path / "s.07.png") == bytes_of(folder.path / "s.01.png")) << "nothing moved";
}
INSTANTIATE_TEST_SUITE_P(Ways, SequenceBytes,
                         testing::Values(Way{"light-prepass", {}},
                                         Way{"shadows on the camera's path",
                                             {"--lights", "5", "--set", "shadows=on", "--camera", "flight"}},
                                         Way{"deferred, framed", {"--renderer", "deferred", "--view-from", "30,20"}},
                                         Way{"z-prepass", {"--renderer", "z-prepass"}}));

TEST(Sequence, ShardsTogetherAreOneRun) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path / "one");
    const Words options{"sequence", "motion", "--size", "64x36", "--fps", "2", "--frames-at", "0-99"};
    const Result one = run(joined(options, {"-o", "one/s.##.exr"}), folder.path);
    ASSERT_TRUE(succeeded(one));
    EXPECT_THAT(one.out, HasSubstr("one/s.07.exr: frame 7, ")) << "a line a frame";
    size_t frames = 0;
    for (const char* shard : {"1/3", "2/3", "3/3"})
        ASSERT_TRUE(succeeded(run(joined(options, {"-o", "s.##.exr", "--shard", shard}), folder.path)));
    for (const auto& entry : fs::directory_iterator(folder.path / "one")) {
        ++frames;
        EXPECT_TRUE(bytes_of(entry.path()) == bytes_of(folder.path / entry.path().filename())) << entry.path();
    }
    EXPECT_EQ(frames, 8u) << "of 4 s, the range's end is the sequence's";
    EXPECT_EQ(folder.entries(), frames + 1);
}

TEST(Sequence, AnEmptyShardIsDone) {
    const TemporaryFolder folder;
    const Result result = run({"sequence", "motion", "--size", "64x36", "--frames-at", "0,1", "-o", "s.##.png",
                               "--shard", "3/9", "--stats", "s.json"},
                              folder.path);
    EXPECT_TRUE(succeeded(result));
    EXPECT_THAT(visible(folder.path), ElementsAre("s.json"));
    EXPECT_THAT(result.out, HasSubstr("no frame for shard 3/9"));
}

TEST(Sequence, TheAnimationsSayHowLong) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(
        {"sequence", "motion", "--size", "32x18", "--fps", "1", "-o", "s.#.png", "--stats", "s.json", "--count-pairs"},
        folder.path)));
    EXPECT_THAT(visible(folder.path), ElementsAre("s.0.png", "s.1.png", "s.2.png", "s.3.png", "s.json"));
    const auto stats = nlohmann::json::parse(bytes_of(folder.path / "s.json"));
    EXPECT_EQ(stats["frames"], 4);
    EXPECT_EQ(stats["sequence"]["frames"], "0-3");
    EXPECT_EQ(stats["sequence"]["drawn"], 4);
    EXPECT_GT(stats["sequence"]["frames_per_hour"], 0);
    EXPECT_GT(stats["passes"].size(), 2u);
    EXPECT_LT(stats["wall_ms"]["min"], stats["wall_ms"]["max"]);
    EXPECT_GT(stats["light_pixel_pairs"]["evaluated"], 0);
}

TEST(Sequence, ATurntableBeginsWhereRenderLooks) {
    const TemporaryFolder folder;
    const Words options{"spheres", "--size", "64x36"};
    ASSERT_TRUE(succeeded(
        run(joined({"sequence"}, joined(options, {"--turntable", "1", "--fps", "3", "-o", "s.#.png"})), folder.path)));
    ASSERT_TRUE(
        succeeded(run(joined({"render", "--msaa", "1", "--set", "antialiasing=smaa"}, joined(options, {"-o", "r.png"})),
                      folder.path)))
        << "edges are smooth unless something else is said";
    EXPECT_THAT(visible(folder.path), ElementsAre("r.png", "s.0.png", "s.1.png", "s.2.png"));
    EXPECT_TRUE(bytes_of(folder.path / "s.0.png") == bytes_of(folder.path / "r.png"));
    EXPECT_FALSE(bytes_of(folder.path / "s.1.png") == bytes_of(folder.path / "r.png"));
}

TEST(Sequence, ALoopBeginsAgain) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run({"sequence", "motion", "--size", "64x36", "--loop", "9", "--fps", "2", "--frames-at",
                               "1,9,17", "-o", "s.##.png"},
                              folder.path)));
    EXPECT_TRUE(bytes_of(folder.path / "s.01.png") == bytes_of(folder.path / "s.09.png")) << "its length is 4 s";
    EXPECT_TRUE(bytes_of(folder.path / "s.01.png") == bytes_of(folder.path / "s.17.png"));
}

TEST(Sequence, OneExposureForAllFrames) {
    const TemporaryFolder folder;
    const auto draw = [&](const Words& words) {
        const Result result = run(
            joined({"sequence", "motion", "--size", "64x36", "--fps", "2", "--exposure", "auto"}, words), folder.path);
        EXPECT_TRUE(succeeded(result));
        return result.out.substr(0, result.out.find('\n'));
    };
    const std::string all = draw({"--frames-at", "0-3", "-o", "a.#.png"});
    EXPECT_THAT(all, HasSubstr("--exposure"));
    EXPECT_EQ(draw({"--frames-at", "3", "-o", "b.#.png"}), all);
    EXPECT_TRUE(bytes_of(folder.path / "a.3.png") == bytes_of(folder.path / "b.3.png"));
}

TEST(Sequence, WhatCannotBeIsToldBeforeWork) {
    const TemporaryFolder folder;
    save_png(Image(2, 1), folder.path / "sky.0001.png");
    const auto refused = [&](int status, const Words& words, const char* part) {
        SCOPED_TRACE(testing::PrintToString(words));
        const Result result = run(joined({"sequence", "--size", "32x18"}, words), folder.path);
        EXPECT_TRUE(failed_with(result, status));
        EXPECT_THAT(result.err, HasSubstr(part));
        EXPECT_EQ(result.out, "");
    };
    refused(2, {"spheres", "-o", "s.#.png"}, "spheres: has no animation");
    refused(2, {"motion", "-o", "s.png"}, "120 frames need a # for their numbers, as in s.####.png");
    refused(2, {"motion", "-o", "s.#.png", "--view", "depth=d.png"}, "--view d.png");
    refused(2, {"motion", "-o", "s.#.png", "--view", "depth=./s.#.png"}, "named for two outputs");
    refused(2, {"motion", "-o", "s.#.png", "--frames-at", "900-999"}, "frames 0 to 119");
    refused(2, {"motion", "-o", "s.#.png", "--animation", "nothing"}, "nothing");
    refused(2, {"motion", "-o", "s.#.png", "--camera", "nothing"}, "nothing");
    refused(2, {"motion", "-o", "sky.####.png", "--environment", "sky.0001.png"}, "is read by this run");
    refused(1, {"motion", "-o", "nowhere/s.#.png"}, "nowhere");
    EXPECT_THAT(visible(folder.path), ElementsAre("sky.0001.png"));
    EXPECT_TRUE(
        succeeded(run({"sequence", "motion", "--size", "32x18", "--frames-at", "5", "-o", "one.png"}, folder.path)));
}

/// Notes what it is given.
class NotingRenderer : public Renderer {
public:
    void set_world(const World& world) override { worlds.push_back(&world); }
    void share_world(const Renderer&) override {}
    const World* world() const override { return worlds.empty() ? nullptr : worlds.back(); }
    void update_world(const WorldChanges& changes) override { updates.push_back(changes); }
    void set_lights(std::span<const PlacedLight>) override {}
    void resize(uint32_t, uint32_t) override {}
    void render(const PlacedCamera&, uint32_t) override {}
    Image read(std::string_view) override { return {}; }
    Texels texels(std::string_view) override { return {}; }
    Stats stats() const override { return {}; }
    uint64_t max_lights() const override { return 65536; }
    std::vector<const World*> worlds;
    std::vector<WorldChanges> updates;
};

std::unique_ptr<app::SceneAtTime> scene_at_time(const char* name) {
    return std::make_unique<app::SceneAtTime>(
        app::load_scene(name, {}, 1, 65536, {.moment = Moment{}, .animation = {}}), app::SceneTime{}, app::SceneView{},
        0, true);
}

TEST(SceneAtTime, AStillSceneIsTakenInOnce) {
    NotingRenderer renderer;
    const auto scene = scene_at_time("spheres");
    EXPECT_FALSE(scene->moves());
    EXPECT_EQ(scene->length(), std::nullopt);
    for (const double time : {0.0, 1.0, 0.5}) {
        scene->prepare(time + 1);
        EXPECT_EQ(&scene->show(time, renderer), &scene->start());
    }
    EXPECT_THAT(renderer.worlds, ElementsAre(&scene->start()));
}

TEST(SceneAtTime, AMovingSceneIsAsAtThatTime) {
    NotingRenderer renderer;
    const auto scene = scene_at_time("motion");
    EXPECT_TRUE(scene->moves());
    EXPECT_NEAR(scene->length().value(), 4, 1e-6);
    for (const double time : {0.5, 0.7, 2.0, 2.0, 0.5}) {
        scene->prepare(time == 2.0 ? 2.0 : 3.0); // what was prepared for another time does not show
        const World& world = scene->show(time, renderer);
        const World expected = resolve(scene->scene(), {}, Moment{.time = time});
        ASSERT_EQ(world.instances.size(), expected.instances.size());
        for (size_t i = 0; i < world.instances.size(); ++i)
            EXPECT_EQ(world.instances[i].transform, expected.instances[i].transform);
    }
    EXPECT_EQ(renderer.worlds.size(), 1u);
    EXPECT_EQ(renderer.updates.size(), 3u) << "one moment was there already";
    EXPECT_FALSE(renderer.updates[0].all);
}

TEST(SequenceStats, AreOfAllFrames) {
    app::SequenceStats gathered;
    for (const double ms : {3.0, 1.0, 8.0}) {
        Stats stats;
        stats.frames = 1;
        stats.wall_ms = {ms, ms, ms};
        stats.passes = {{"light", {2 * ms, 2 * ms, 2 * ms}}};
        if (ms == 1)
            stats.passes.push_back({"extra", {5, 5, 5}});
        stats.pairs_evaluated = static_cast<uint64_t>(ms);
        stats.device_bytes = static_cast<uint64_t>(100 * ms);
        stats.lights = static_cast<uint64_t>(ms);
        stats.notes = {"the same"};
        gathered.add(stats);
    }
    const Stats all = gathered.all();
    EXPECT_EQ(all.frames, 3u);
    EXPECT_EQ(all.wall_ms.min, 1);
    EXPECT_EQ(all.wall_ms.median, 3);
    EXPECT_EQ(all.wall_ms.max, 8);
    ASSERT_EQ(all.passes.size(), 2u);
    EXPECT_EQ(all.passes[0].gpu_ms.median, 6);
    EXPECT_EQ(all.passes[1].gpu_ms.max, 5);
    EXPECT_EQ(all.pairs_evaluated, 12u);
    EXPECT_EQ(all.device_bytes, 800u);
    EXPECT_EQ(all.lights, 8u);
    EXPECT_THAT(all.notes, ElementsAre("the same"));
}

} // namespace
} // namespace prelight::test
