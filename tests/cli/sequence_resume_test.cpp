// Sequences that are ended in the middle, and that go on.
#include "files.hpp"
#include "process.hpp"

#include <csignal>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <prelight/image.hpp>

namespace prelight::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

size_t frames_in(const fs::path& folder) {
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
        count += entry.path().filename().string().starts_with("s.");
    return count;
}

class InterruptedSequence : public testing::TestWithParam<int> {};

TEST_P(InterruptedSequence, LeavesWholeFrames) {
    const TemporaryFolder folder;
    Prelight program({"sequence", "spheres", "--size", "160x90", "--frames-at", "0-99999", "-o", "s.#####.png",
                      "--view", "normal=s.n#####.png"},
                     folder.path);
    ASSERT_TRUE(eventually([&] { return frames_in(folder.path) >= 10; }));
    program.send(GetParam());
    const Result result = program.wait();
    EXPECT_EQ(result.signal, GetParam()) << result.err;
    EXPECT_FALSE(result.timed_out);
    std::set<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder.path)) {
        EXPECT_NO_THROW(load_png(entry.path())) << entry.path();
        files.insert(entry.path().filename());
    }
    EXPECT_GE(files.size(), 10u);
    for (const std::string& file : files) // a frame is whole with both of its files
        EXPECT_TRUE(files.contains(file[2] == 'n' ? "s." + file.substr(3) : "s.n" + file.substr(2))) << file;
}
INSTANTIATE_TEST_SUITE_P(Signals, InterruptedSequence, testing::Values(SIGINT, SIGTERM));

TEST(ResumedSequence, AKilledRunGoesOn) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path / "one");
    const Words options{"sequence", "motion", "--size", "64x36", "--fps", "10", "--skip-existing"};
    Prelight program(joined(options, {"-o", "s.##.png"}), folder.path);
    ASSERT_TRUE(eventually([&] { return frames_in(folder.path) >= 5; }));
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().signal, SIGKILL);
    const size_t before = frames_in(folder.path);
    EXPECT_LT(before, 40u) << "killed too late: nothing was tested";
    const Result resumed = run(joined(options, {"-o", "s.##.png"}), folder.path);
    ASSERT_TRUE(succeeded(resumed));
    EXPECT_THAT(resumed.out, HasSubstr("s.00.png: frame 0 is there\n"));
    ASSERT_TRUE(succeeded(run(joined(options, {"-o", "one/s.##.png"}), folder.path)));
    EXPECT_EQ(frames_in(folder.path / "one"), 40u);
    EXPECT_EQ(frames_in(folder.path), 40u);
    for (const auto& entry : fs::directory_iterator(folder.path / "one"))
        EXPECT_TRUE(bytes_of(entry.path()) == bytes_of(folder.path / entry.path().filename())) << entry.path();
}

/// What a crash, a full disk or a bad copy leaves.
struct Damage {
    const char* name;
    void (*damage)(const fs::path& file);
};

const Damage damages[] = {
    {"missing", [](const fs::path& file) { fs::remove(file); }},
    {"empty", [](const fs::path& file) { write(file, ""); }},
    {"half", [](const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); }},
    {"short of a byte", [](const fs::path& file) { fs::resize_file(file, fs::file_size(file) - 1); }},
    {"a byte is wrong",
     [](const fs::path& file) {
         std::string bytes = bytes_of(file);
         bytes[bytes.size() * 2 / 3] = static_cast<char>(bytes[bytes.size() * 2 / 3] ^ 0x10);
         write(file, bytes);
     }},
    {"something else", [](const fs::path& file) { write(file, "not a picture"); }},
    {"zeros",
     [](const fs::path& file) {
         write(file, std::string(fs::file_size(file), '\0')); // as after a power cut
     }},
};

class DamagedFrame : public testing::TestWithParam<const char*> {};

TEST_P(DamagedFrame, IsDrawnAgain) {
    const TemporaryFolder folder;
    const std::string extension = GetParam();
    const Words options{"sequence", "spheres",         "--size", "64x36",           "--frames-at",
                        "0-9",      "--skip-existing", "-o",     "s.#." + extension};
    const auto file = [&](size_t frame) { return folder.path / fmt::format("s.{}.{}", frame, extension); };
    ASSERT_TRUE(succeeded(run(options, folder.path)));
    const std::string good = bytes_of(file(9));
    const auto untouched = fs::last_write_time(file(9));
    size_t damaged = 0;
    std::string what[10];
    for (const Damage& damage : damages)
        if (extension == "png" || damage.damage != damages[4].damage) { // an EXR has no checksum
            what[damaged] = damage.name;
            damage.damage(file(damaged++));
        }
    const Result result = run(options, folder.path);
    ASSERT_TRUE(succeeded(result));
    for (size_t frame = 0; frame < 10; ++frame) {
        SCOPED_TRACE(fmt::format("frame {}: {}", frame, what[frame]));
        EXPECT_TRUE(bytes_of(file(frame)) == good);
        const std::string line = fmt::format("s.{}.{}: frame {} is there\n", frame, extension, frame);
        if (frame < damaged)
            EXPECT_THAT(result.out, Not(HasSubstr(line)));
        else
            EXPECT_THAT(result.out, HasSubstr(line));
    }
    EXPECT_EQ(fs::last_write_time(file(9)), untouched);
    EXPECT_THAT(run(options, folder.path).out, HasSubstr("all 10 frames are there"));

    // A picture of another size is not this frame.
    Words larger = options;
    larger[3] = "32x18";
    EXPECT_THAT(run(larger, folder.path).out, AllOf(HasSubstr("10 of 10"), Not(HasSubstr("is there"))));
}
INSTANTIATE_TEST_SUITE_P(Formats, DamagedFrame, testing::Values("png", "exr"));

TEST(ResumedSequence, AFrameIsThereWithAllItsBuffers) {
    const TemporaryFolder folder;
    const Words options{"sequence",        "spheres", "--size",  "64x36",  "--frames-at",   "0-2",
                        "--skip-existing", "-o",      "s.#.png", "--view", "normal=n.#.png"};
    ASSERT_TRUE(succeeded(run(options, folder.path)));
    fs::remove(folder.path / "n.1.png");
    const Result result = run(options, folder.path);
    EXPECT_THAT(result.out, AllOf(HasSubstr("frame 0 is there"), HasSubstr("s.1.png: frame 1, 1 of 1")));
    EXPECT_TRUE(fs::exists(folder.path / "n.1.png"));
}

} // namespace
} // namespace prelight::test
