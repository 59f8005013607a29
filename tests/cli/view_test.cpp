// `prelight view --play`: what input makes of the picture, without a window.
#include "files.hpp"
#include "process.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <random>
#include <view/keys.hpp>
#include <view/recording.hpp>
#include <view/scale_control.hpp>
#include <view/session.hpp>

namespace prelight::test {
namespace {

using namespace app::viewer;
using testing::HasSubstr;

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

const std::string head = "prelight view 1\nsize 96x54\n";

/// The picture at the recording's end.
std::string played(const std::filesystem::path& folder, const std::string& events,
                   const std::vector<std::string>& more = {}, const std::string& scene = "spheres") {
    write(folder / "r.txt", head + events);
    const Result result = run(joined({"view", scene, "--play", "r.txt", "-o", "p.png", "--validate"}, more), folder);
    EXPECT_TRUE(succeeded(result));
    return bytes_of(folder / "p.png");
}

std::string rendered(const std::filesystem::path& folder, const std::vector<std::string>& more,
                     const std::string& scene = "spheres") {
    const Result result = run(joined({"render", scene, "--size", "96x54", "--msaa", "1", "-o", "q.png"}, more), folder);
    EXPECT_TRUE(succeeded(result));
    return bytes_of(folder / "q.png");
}

TEST(View, ARecordingGivesTheBytesThatRenderGives) {
    const TemporaryFolder folder;
    EXPECT_TRUE(played(folder.path, "") == rendered(folder.path, {})) << "as it starts";
    EXPECT_TRUE(played(folder.path, "3 set light-culling clusters\n5 renderer deferred\n") ==
                rendered(folder.path, {"--renderer", "deferred", "--set", "light-culling=clusters"}))
        << "another renderer";
    EXPECT_TRUE(played(folder.path, "3 key 2 down\n3 key 2 up\n") == rendered(folder.path, {"--view", "normal"}))
        << "a buffer by its key";
    EXPECT_TRUE(played(folder.path, "3 key 2 down\n4 key 2 down\n") == rendered(folder.path, {})) << "and back";
    EXPECT_TRUE(played(folder.path, "2 time 0.4\n", {}, "motion") == rendered(folder.path, {"--time", "0.4"}, "motion"))
        << "a moment";
    EXPECT_TRUE(played(folder.path, "1 key Space down\n", {"--frames", "31"}, "motion") ==
                rendered(folder.path, {"--time", "0.5"}, "motion"))
        << "thirty steps of playing are half a second";
    EXPECT_TRUE(played(folder.path, "1 resize 60 60\n4 resize 0 0\n6 resize 96 54\n") == rendered(folder.path, {}))
        << "sizes, minimised too";
}

/// The session that the recording makes, in this process.
std::unique_ptr<Session> session_of(const std::string& events, uint32_t steps, const std::string& scene = "spheres") {
    const Recording recording = parse_recording(head + events, "r");
    app::RenderCommand command;
    command.scene = scene;
    auto session = std::make_unique<Session>(command, recording.width, recording.height);
    auto event = recording.events.begin();
    while (session->steps() < steps) {
        for (; event != recording.events.end() && event->step == session->steps(); ++event)
            session->apply(*event);
        session->step();
    }
    return session;
}

TEST(View, FlyingGivesTheBytesThatTheLibraryGivesFromTheSameCameraAndLights) {
    const TemporaryFolder folder;
    const std::string events =
        "0 key W down\n9 key W up\n10 button left down 20 20\n11 move 34 15\n12 button left up 34 15\n"
        "13 wheel 0 2\n14 button middle down 5 5\n15 move 9 2\n16 button middle up 9 2\n"
        "17 button right down 5 5\n18 move 12 2\n19 button right up 12 2\n20 key Left down\n"
        "24 key Left up\n25 add-light\n26 light-colour 0 1 0 0\n27 move-light 1 0.5 0.5 0\n"
        "28 remove-light 2\n";
    const auto session = session_of(events, 40);
    EXPECT_TRUE(session->messages().empty());
    const auto device = Device::create({});
    const auto renderer =
        create_renderer("light-prepass", device.get(), {.width = 96, .height = 54, .views = {"final"}});
    World world = session->stage().world();
    world.lights = session->shining();
    EXPECT_EQ(world.lights.size(), 8u); // one came, one went
    renderer->set_world(world);
    renderer->render(session->camera());
    save_png(renderer->read("final"), folder.path / "library.png");
    const std::string picture = played(folder.path, events, {"--frames", "40"});
    EXPECT_TRUE(picture == bytes_of(folder.path / "library.png"));
    EXPECT_FALSE(picture == rendered(folder.path, {})) << "nothing has moved";
}

/// A session in `folder` with the scene of a file.
std::unique_ptr<Session> session_of_file(const std::filesystem::path& scene) {
    app::RenderCommand command;
    command.scene = scene.string();
    command.reading.log_level = app::LogLevel::error;
    return std::make_unique<Session>(command, 96, 54);
}

TEST(View, AFileThatChangesIsReadAgainAndABadOneChangesNothing) {
    const TemporaryFolder folder;
    const auto make = [&](const char* lights) {
        ASSERT_TRUE(succeeded(run({"make", "spheres", "--lights", lights, "-o", "s.glb"}, folder.path)));
    };
    make("3");
    const auto session = session_of_file(folder.path / "s.glb");
    EXPECT_EQ(session->shining().size(), 3u);
    session->apply({0, "wheel", {"0", "3"}});
    const glm::dvec3 place = session->camera().position;
    make("5");
    session->apply({0, "reload", {}});
    EXPECT_EQ(session->shining().size(), 5u);
    EXPECT_EQ(session->camera().position, place) << "the camera stays";
    EXPECT_TRUE(session->messages().empty());
    write(folder.path / "s.glb", "no scene");
    session->apply({0, "reload", {}});
    EXPECT_EQ(session->shining().size(), 5u);
    ASSERT_EQ(session->messages().size(), 1u);
    EXPECT_THAT(session->messages()[0], HasSubstr("s.glb"));
    session->apply({0, "drop", {"motion"}});
    EXPECT_EQ(session->scene_name(), "motion");
    EXPECT_NE(session->camera().position, place) << "another scene, its own camera";
}

TEST(View, LightsAndObjectsAreEditedByNumber) {
    const auto session = session_of("", 0);
    const auto light = [&](uint32_t number) { return session->stage().light(number); };
    const glm::dvec3 before = light(2)->position;
    session->apply({0, "move-light", {"2", "1", "2", "3"}});
    EXPECT_LT(glm::length(light(2)->position - before - glm::dvec3(1, 2, 3)), 1e-12);
    session->apply({0, "light-intensity", {"2", "7.5"}});
    session->apply({0, "light-range", {"2", "0"}});
    EXPECT_EQ(light(2)->light.intensity, 7.5f);
    EXPECT_TRUE(std::isinf(light(2)->light.range));
    session->apply({0, "remove-light", {"1"}});
    EXPECT_FALSE(light(1));
    EXPECT_EQ(light(2)->light.intensity, 7.5f) << "numbers stay";
    session->apply({0, "select-light", {"2"}});
    session->apply({0, "only-selected", {"on"}});
    ASSERT_EQ(session->shining().size(), 1u);
    EXPECT_EQ(session->shining()[0].light.intensity, 7.5f);
    session->apply({0, "pick-object", {"52.5", "27"}});
    ASSERT_EQ(session->selection().kind, SelectionKind::object);
    const uint32_t node = session->selection().number;
    const auto place = [&] {
        for (const Instance& instance : session->stage().world().instances)
            if (instance.node == node)
                return glm::dvec3(instance.transform[3]);
        return glm::dvec3(0);
    };
    const glm::dvec3 was = place();
    session->apply({0, "move-object", {std::to_string(node), "0", "0", "4"}});
    EXPECT_LT(glm::length(place() - was - glm::dvec3(0, 0, 4)), 1e-12);
    EXPECT_TRUE(session->messages().empty());
}

TEST(View, TimeRunsBackwardsToo) {
    const auto time = [](const std::string& events, uint32_t steps, const char* scene = "motion") {
        return session_of(events, steps, scene)->time();
    };
    EXPECT_NEAR(time("0 time 1\n0 speed -1\n0 play on\n", 30), 0.5, 1e-9);
    EXPECT_NEAR(time("0 speed -2\n0 play on\n", 30), 3, 1e-9) << "before its beginning is its end, at 4 s";
    EXPECT_NEAR(time("0 time 1\n0 speed -1\n0 play on\n30 speed 1\n", 60), 1, 1e-9) << "and back";
    // Particles have a beginning, and no end to come from.
    EXPECT_EQ(time("0 time 0.1\n0 speed -1\n0 play on\n", 30, "city-sparks"), 0);
}

TEST(View, AScreenshotIsOfTheStepThatAsksForIt) {
    const TemporaryFolder folder;
    const std::string end = played(
        folder.path, "1 wheel 0 2\n2 screenshot early.png\n3 wheel 0 2\n5 screenshot last.png\n", {"--frames", "6"});
    EXPECT_TRUE(bytes_of(folder.path / "last.png") == end) << "asked for at the very last step";
    EXPECT_TRUE(bytes_of(folder.path / "early.png") == played(folder.path, "1 wheel 0 2\n"));
    write(folder.path / "r.txt", head + "1 resize 0 0\n2 screenshot none.png\n3 resize 96 54\n");
    const Result minimised = run({"view", "spheres", "--play", "r.txt", "-o", "p.png"}, folder.path);
    EXPECT_EQ(minimised.status, 0);
    EXPECT_THAT(minimised.err, HasSubstr("step 3: screenshot none.png: a window that is minimised has no picture"));
    EXPECT_FALSE(std::filesystem::exists(folder.path / "none.png"));
}

TEST(View, ScaleAutoGoesDownWhereItIsSlowAndBackWhereNothingMoves) {
    ScaleControl control;
    double scale = 1;
    for (int picture = 0; picture < 60; ++picture) // 200 ms for all pixels
        scale = control.moving(200 * scale * scale, scale).value_or(scale);
    EXPECT_EQ(scale, 0.35) << "24.5 ms, and the next larger one would take 50";
    EXPECT_FALSE(control.still(0.1, scale));
    EXPECT_EQ(control.still(0.5, scale), 1.0);
    for (int picture = 0; picture < 60; ++picture) // and 10 ms
        scale = control.moving(10 * scale * scale, scale).value_or(scale);
    EXPECT_EQ(scale, 1);
}

TEST(View, ALostDeviceIsReplaced) {
    const TemporaryFolder folder;
    const std::string without = played(folder.path, "0 set normals oct32\n4 wheel 0 1\n");
    write(folder.path / "r.txt", head + "0 set normals oct32\n2 lose device\n4 wheel 0 1\n");
    const Result once = run({"view", "spheres", "--play", "r.txt", "-o", "p.png", "--validate"}, folder.path);
    EXPECT_EQ(once.status, 0) << once.err;
    EXPECT_THAT(once.err, HasSubstr("the device was lost (VK_ERROR_DEVICE_LOST); everything was made anew"));
    EXPECT_TRUE(bytes_of(folder.path / "p.png") == without);
    std::filesystem::remove(folder.path / "p.png");
    write(folder.path / "r.txt", head + "2 lose device\n3 set normals oct16\n4 lose device\n5 set normals oct32\n");
    const Result twice = run({"view", "spheres", "--play", "r.txt", "-o", "p.png"}, folder.path);
    EXPECT_EQ(twice.status, 1) << twice.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path / "p.png"));
}

TEST(View, WhatCannotBeIsToldAndChangesNothing) {
    const TemporaryFolder folder;
    write(folder.path / "r.txt", head + "1 set light-culling sideways\n2 renderer none\n3 drop gone.glb\n4 buffer x\n"
                                        "5 light-range 99 1\n6 camera nobody\n7 drop gone.hdr\n8 screenshot a.txt\n");
    const Result result = run({"view", "spheres", "--play", "r.txt", "-o", "p.png", "--validate"}, folder.path);
    EXPECT_EQ(result.status, 0);
    for (const char* part :
         {"sideways", "renderer none", "gone.glb", "no buffer x", "light-range 99", "nobody", "gone.hdr", "a.txt"})
        EXPECT_THAT(result.err, HasSubstr(part));
    EXPECT_TRUE(bytes_of(folder.path / "p.png") == rendered(folder.path, {}));
}

TEST(View, BadRecordingsAreRefusedInOneLine) {
    const TemporaryFolder folder;
    const std::pair<std::string, std::string> bad[] = {
        {"", "ends before its size"},
        {"GIF89a", "line 1: not a recording"},
        {"prelight view 1\n", "ends before its size"},
        {"prelight view 1\nsize 0x10\n", "line 2: size 0x10"},
        {"prelight view 1\nsize 99999x10\n", "more than 16384"},
        {head + "1 jump\n", "line 3: jump: not an event"},
        {head + "x key W down\n", "not the number of a step"},
        {head + "-1 key W down\n", "not the number of a step"},
        {head + "1 key W\n", "has 2 arguments, and 1 came"},
        {head + "1 key Hyper down\n", "Hyper is not a key"},
        {head + "1 move nan 1\n", "nan is not a number"},
        {head + "1 move 1e300 1\n", "is not a number"},
        {head + "2 frame\n1 frame\n", "line 4: step 1: after step 2"},
        {head + "99999999 frame\n", "later than"},
        {head + "1 drop \"a\n", "not closed"},
        {head + "1 resize 1.5 2\n", "not a whole number"},
        {head + std::string("1 key \x01\0 down\n", 15), "is not a key"},
    };
    for (const auto& [text, reason] : bad) {
        try {
            parse_recording(text, "r.txt");
            FAIL() << text;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(reason));
        }
    }
    write(folder.path / "r.txt", head + "1 jump\n");
    const Result result = run({"view", "spheres", "--play", "r.txt", "-o", "p.png"}, folder.path);
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_THAT(result.err, HasSubstr("r.txt: line 3: jump"));
    EXPECT_FALSE(std::filesystem::exists(folder.path / "p.png"));
    EXPECT_TRUE(failed_with(run({"view", "spheres", "-o", "p.png"}, folder.path), 2));
    EXPECT_TRUE(failed_with(run({"view", "spheres", "--play", "r.txt", "-o", "r.txt"}, folder.path), 2));
}

TEST(View, EventsAreReadAsTheyWereWritten) {
    Recording recording;
    recording.events = {{0, "key", {"W", "down"}},
                        {3, "drop", {"a b/\"c\"\\d\n.glb"}},
                        {3, "preset", {""}},
                        {9, "move", {"1.25", "-7"}}};
    EXPECT_EQ(parse_recording(recording_text(recording), "r").events, recording.events);
}

TEST(View, EveryKeyInTheHelpDoesWhatIsAnEvent) {
    for (const KeyBinding& binding : key_bindings()) {
        EXPECT_TRUE(is_key(binding.key)) << binding.key;
        for (std::string text : binding.events) {
            if (text.ends_with("$x $y"))
                text.replace(text.size() - 5, 5, "1 2");
            EXPECT_NO_THROW(parse_event("0 " + text)) << text;
        }
    }
}

/// Input as a cat on the keyboard makes it.
std::string random_events(uint64_t seed, uint32_t steps) {
    std::mt19937_64 random(seed);
    const auto below = [&](uint64_t n) { return random() % n; };
    const auto one_of = [&](std::initializer_list<const char*> list) {
        return std::string(list.begin()[below(list.size())]);
    };
    const std::string kinds = "tncskdbp";
    std::string text;
    for (uint32_t step = 0; step < steps; step += static_cast<uint32_t>(below(3))) {
        const Verb& verb = app::viewer::verbs()[below(app::viewer::verbs().size())];
        if (verb.name == "lose" || verb.name == "quit" || verb.name == "screenshot" || verb.name == "drop")
            continue;
        Event event{step, std::string(verb.name), {}};
        for (const char kind : verb.arguments)
            event.words.push_back(
                kind == 't'   ? one_of({"light-prepass",
                                        "deferred",
                                        "multipass",
                                        "z-prepass",
                                        "light-culling",
                                        "tiles",
                                        "clusters",
                                        "volumes",
                                        "normals",
                                        "oct32",
                                        "depth",
                                        "normal",
                                        "final",
                                        "engel",
                                        "",
                                        "phong",
                                        "ggx",
                                        "0",
                                        "1",
                                        "shadows",
                                        "on"})
                : kind == 'n' ? std::to_string(static_cast<int>(below(120)) - 20)
                : kind == 'c' ? std::to_string(below(verb.name == "resize" ? 90 : 12))
                : kind == 's' ? one_of({"on", "off", "toggle"})
                : kind == 'k' ? one_of({"W", "A", "S", "D", "Q", "E", "Left", "Up", "Shift",  "F",      "Space", "1",
                                        "2", "3", "4", "H", "L", "O", "N",    "M",  "Insert", "Delete", "R",     "?"})
                : kind == 'd' ? one_of({"down", "up"})
                : kind == 'b' ? one_of({"left", "middle", "right"})
                              : "device");
        text += event_line(event) + "\n";
    }
    return text;
}

/// A number of the environment's.
uint64_t wanted(const char* name, uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// PRELIGHT_VIEW_RECORDINGS=N plays so many (default 2), PRELIGHT_VIEW_STEPS=N such long ones (default 40 steps).
TEST(View, RandomInputEndsInAPictureUnderValidation) {
    const TemporaryFolder folder;
    const uint64_t runs = wanted("PRELIGHT_VIEW_RECORDINGS", 2);
    const auto steps = static_cast<uint32_t>(wanted("PRELIGHT_VIEW_STEPS", 40));
    for (uint64_t seed = 1; seed <= runs; ++seed) {
        const std::string text = random_events(seed, steps) + fmt::format("{} resize 96 54\n", steps);
        write(folder.path / "r.txt", head + text);
        const char* scene = seed % 2 ? "motion" : "spheres";
        const Result result = run({"view", scene, "--play", "r.txt", "-o", "p.png", "--validate"}, folder.path,
                                  {.seconds = 60 + 0.1 * steps});
        EXPECT_EQ(result.status, 0) << "seed " << seed << ": " << result.err << (steps > 40 ? "" : text);
        EXPECT_TRUE(std::filesystem::exists(folder.path / "p.png"));
    }
}

} // namespace
} // namespace prelight::test
