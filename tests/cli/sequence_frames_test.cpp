// Lists of frames, their times and names, and the turntable: what needs no process.
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <numeric>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <random>
#include <sequence/frame_list.hpp>
#include <sequence/frame_rate.hpp>
#include <sequence/numbered_name.hpp>
#include <sequence/plan.hpp>
#include <sequence/turntable.hpp>

namespace prelight::test {
namespace {

using namespace app;
using testing::ElementsAre;
using testing::HasSubstr;

FrameNumbers numbers(const std::string& text) { return frames_of(parse_frame_ranges("--frames-at", text)); }

TEST(FrameList, TakesWhatFarmsWrite) {
    EXPECT_THAT(numbers("47"), ElementsAre(47));
    EXPECT_THAT(numbers("1-5"), ElementsAre(1, 2, 3, 4, 5));
    EXPECT_THAT(numbers("3,5-7"), ElementsAre(3, 5, 6, 7));
    EXPECT_THAT(numbers("3, 5-7 , 9"), ElementsAre(3, 5, 6, 7, 9));
    EXPECT_THAT(numbers("1-10x3"), ElementsAre(1, 4, 7, 10));
    EXPECT_THAT(numbers("1-9x3"), ElementsAre(1, 4, 7));
    EXPECT_THAT(numbers("4-4"), ElementsAre(4));
    EXPECT_THAT(numbers("9,0-20x10,0-2"), ElementsAre(9, 0, 10, 20, 1, 2)) << "in the order given, each once";
    EXPECT_EQ(numbers("1-100x3").size(), 34u);
}

TEST(FrameList, RefusesWhatIsNone) {
    for (const char* text : {"",       ",",     "1,",   ",1",    "1,,2",       "a",         "1-",
                             "-1",     "1-2-3", "1-9x", "1-9x0", "9-1",        "5x2",       "1 2",
                             "1-9 x3", "+1",    "0x10", "1.5",   "4294967296", "100000000", "99999999999999999999"}) {
        SCOPED_TRACE(text);
        try {
            numbers(text);
            ADD_FAILURE() << "was taken";
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr("--frames-at "));
        }
    }
}

TEST(FrameList, HugeListsAreRefusedBeforeTheyAreMade) {
    EXPECT_THROW(numbers("0-99999999"), UsageError);
    EXPECT_THROW(numbers("0-4294967295"), UsageError);
    std::string many = "0-999999";
    for (int i = 0; i < 50; ++i)
        many += ",0-999999"; // the same frames again count too: the text says how long it takes
    EXPECT_THROW(numbers(many), UsageError);
    EXPECT_EQ(numbers("0-99999999x100").size(), most_frames);
}

TEST(FrameList, IsReadAsItIsPrinted) {
    std::mt19937 random(7);
    for (int round = 0; round < 3000; ++round) {
        // Runs with steps, single numbers and jumps back, each number once.
        FrameNumbers frames;
        std::set<uint32_t> seen;
        for (int part = static_cast<int>(random() % 6); part >= 0; --part) {
            uint32_t frame = random() % (round % 2 ? 40 : 100000);
            const uint32_t step = 1 + random() % 4;
            for (uint32_t i = random() % 6; i > 0; --i, frame += step)
                if (seen.insert(frame).second)
                    frames.push_back(frame);
        }
        if (!frames.empty()) {
            ASSERT_EQ(numbers(print_frames(frames)), frames) << print_frames(frames);
        }
    }
    EXPECT_EQ(print_frames({}), "");
    EXPECT_EQ(print_frames(numbers("0,1,2,5,8,11,20,7")), "0-2,5-11x3,20,7");
}

TEST(FrameList, ShardsAreAllOfItOnceAndEven) {
    const FrameNumbers frames = numbers("3-40x2,0,100-110");
    for (const uint32_t count : {1u, 2u, 3u, 7u, 29u, 30u, 31u, 100u}) {
        FrameNumbers together;
        size_t least = frames.size(), most = 0;
        for (uint32_t i = 1; i <= count; ++i) {
            const FrameNumbers own = shard_of(frames, {i, count});
            least = std::min(least, own.size());
            most = std::max(most, own.size());
            together.insert(together.end(), own.begin(), own.end());
        }
        EXPECT_LE(most - least, 1u) << count;
        EXPECT_THAT(together, testing::UnorderedElementsAreArray(frames)) << count;
    }
    EXPECT_THAT(shard_of({5, 6, 7, 8, 9}, {2, 3}), ElementsAre(6, 9));
    for (const char* text : {"", "1", "0/3", "4/3", "1/0", "1/3/5", "a/3", "1/ 3", "-1/3"})
        EXPECT_THROW(parse_shard("--shard", text), UsageError) << text;
    EXPECT_EQ(parse_shard("--shard", "2/6").index, 2u);
}

TEST(FrameList, RangesEndWithTheSequenceAndNumbersDoNot) {
    SequenceOptions options;
    options.rate = parse_frame_rate("--fps", "10");
    const auto frames = [&](const std::string& text, std::optional<double> length, bool endless = false) {
        options.frames_text = text;
        options.frames = parse_frame_ranges("--frames-at", text);
        return all_frames(options, "a.glb", length, endless);
    };
    EXPECT_THAT(frames("2-9", 0.5), ElementsAre(2, 3, 4));
    EXPECT_THAT(frames("2-9,7", 0.5), ElementsAre(2, 3, 4, 7));
    EXPECT_THAT(frames("3-6", 0.5, true), ElementsAre(3, 4, 5, 6)) << "particles go on";
    EXPECT_THAT(frames("3-6", std::nullopt), ElementsAre(3, 4, 5, 6)) << "a still scene";
    EXPECT_THROW(frames("6-9", 0.5), UsageError);
    EXPECT_THROW(frames("10000001", 0.5), UsageError) << "later than --time may be";
    options.frames.clear();
    EXPECT_THAT(all_frames(options, "a.glb", 0.5, true), ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THROW(all_frames(options, "a.glb", {}, false), UsageError);
    EXPECT_THROW(all_frames(options, "a.glb", {}, true), UsageError);
    EXPECT_THROW(all_frames(options, "a.glb", 1e6, false), UsageError) << "more than one list may have";
    options.turntable = 0.3;
    EXPECT_THAT(all_frames(options, "a.glb", 0.5, false), ElementsAre(0, 1, 2)) << "one round";
    options.turntable.reset();
    options.loop = 0.7;
    EXPECT_THAT(all_frames(options, "a.glb", 0.2, false), ElementsAre(0, 1, 2, 3, 4, 5, 6));
    EXPECT_THROW(all_frames(options, "a.glb", {}, false), UsageError) << "nothing to repeat";
}

TEST(FrameList, AnimationsAreShownToTheirEnd) {
    SequenceOptions options;
    EXPECT_EQ(frames_in(options, 2.0), 60u);
    EXPECT_EQ(frames_in(options, double(2.0000001f)), 60u);
    EXPECT_EQ(frames_in(options, 2.01), 61u);
    EXPECT_EQ(frames_in(options, 0.0), 1u);
    EXPECT_EQ(frames_in(options, {}), std::nullopt);
    options.turntable = 10;
    EXPECT_EQ(frames_in(options, 2.0), 300u);
    options.rate = parse_frame_rate("--fps", "30000/1001");
    EXPECT_EQ(frames_in(options, {}), 300u); // 299.7
}

TEST(FrameRate, GivesTheTimeThatIsWritten) {
    EXPECT_EQ(parse_frame_rate("--fps", "30").time_of(3), 0.1);
    EXPECT_EQ(parse_frame_rate("--fps", "10").time_of(7), 0.7);
    EXPECT_EQ(parse_frame_rate("--fps", "23.976").time_of(0), 0.0);
    EXPECT_EQ(parse_frame_rate("--fps", "30000/1001").time_of(30000), 1001.0);
    for (const char* text : {"", "0", "-1", "a", "30/", "/2", "1/0", "inf", "1e9", "1/4000000", "30 "})
        EXPECT_THROW(parse_frame_rate("--fps", text), UsageError) << text;
}

TEST(NumberedName, PadsToItsRun) {
    EXPECT_EQ(NumberedName("-o", "a/b.####.png").at(7), "a/b.0007.png");
    EXPECT_EQ(NumberedName("-o", "b#.exr").at(12), "b12.exr");
    EXPECT_EQ(NumberedName("-o", "##.png").at(12345), "12345.png");
    EXPECT_EQ(NumberedName("-o", "b.png").at(5), "b.png");
    EXPECT_FALSE(NumberedName("-o", "b.png").numbered());
    EXPECT_THROW(NumberedName("-o", "a#/b.png"), UsageError);
    EXPECT_THROW(NumberedName("-o", "a#b#.png"), UsageError);
    EXPECT_THROW(NumberedName("-o", "a.%04d.png"), UsageError);
}

class TurntableTest : public testing::Test {
protected:
    TurntableTest() : scene(make_scene("spheres", 4, 1)), world(resolve(scene)) {}
    Scene scene;
    World world;
    const glm::dvec3 centre = 0.5 * (world.bounds_min + world.bounds_max);
};

TEST_F(TurntableTest, KeepsDistanceHeightAndLook) {
    const PlacedCamera start = look_at({}, centre + glm::dvec3(1, 2, 5), centre);
    const Turntable table(world, start, 8, false);
    EXPECT_EQ(table.at(0, 0.1).position, start.position);
    EXPECT_EQ(table.at(8, 0.1).position, start.position);
    EXPECT_EQ(table.at(16, 0.1).axes, start.axes);
    for (const double time : {0.5, 2.0, 3.7, 7.9, 11.0}) {
        const PlacedCamera camera = table.at(time, 0.25);
        const glm::dvec3 from_centre = camera.position - centre;
        EXPECT_NEAR(from_centre.y, 2, 1e-9);
        EXPECT_NEAR(glm::length(from_centre), std::sqrt(30.0), 1e-9);
        EXPECT_LT(glm::length(glm::normalize(from_centre) - camera.axes[2]), 1e-9) << "it looks at the centre";
        EXPECT_NEAR(camera.axes[0].y, 0, 1e-9) << "upright";
        EXPECT_NEAR(glm::dot(camera.axes[0], glm::cross(camera.axes[1], camera.axes[2])), 1, 1e-9);
        ASSERT_TRUE(camera.previous);
        EXPECT_LT(glm::length(camera.previous->position - table.at(time - 0.25, 0).position), 1e-9);
    }
}

TEST_F(TurntableTest, TurnsOnTheSpotInAStreet) {
    const Scene streets = make_scene("city", 1, 1);
    const World city = resolve(streets);
    const PlacedCamera start = city.cameras[0];
    const Turntable table(city, start, 4, true);
    const PlacedCamera quarter = table.at(1, 0.1);
    EXPECT_EQ(quarter.position, start.position);
    EXPECT_NEAR(glm::dot(quarter.axes[0], start.axes[0]), 0, 1e-12);
    EXPECT_EQ(quarter.camera.zfar, start.camera.zfar);
}

TEST_F(TurntableTest, TurnsAsAzimuthsCount) {
    const PlacedCamera start = look_at({}, centre + glm::dvec3(0, 0, 5), centre); // azimuth 0
    const PlacedCamera quarter = Turntable(world, start, 4, false).at(1, 0.1);    // azimuth 90: from +X
    EXPECT_LT(glm::length(quarter.position - (centre + glm::dvec3(5, 0, 0))), 1e-9);
}

TEST_F(TurntableTest, NothingIsCutOffOnTheWayRound) {
    world.bounds_min = centre - glm::dvec3(1, 1, 20); // long: seen from its end it comes close
    world.bounds_max = centre + glm::dvec3(1, 1, 20);
    Camera near_only;
    near_only.znear = 9;
    near_only.zfar = 12;
    const PlacedCamera start = look_at(near_only, centre + glm::dvec3(30, 3, 0), centre);
    const Turntable table(world, start, 16, true);
    for (int i = 0; i < 16; ++i) {
        const PlacedCamera camera = table.at(i, 0.1);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p(corner & 1 ? world.bounds_max.x : world.bounds_min.x,
                               corner & 2 ? world.bounds_max.y : world.bounds_min.y,
                               corner & 4 ? world.bounds_max.z : world.bounds_min.z);
            const double depth = glm::dot(camera.axes[2], camera.position - p);
            EXPECT_GT(depth, camera.camera.znear);
            EXPECT_LT(depth, camera.camera.zfar);
        }
    }
    EXPECT_EQ(Turntable(world, start, 16, false).at(1, 0.1).camera.zfar, 12) << "a file's camera keeps its planes";
}

} // namespace
} // namespace prelight::test
