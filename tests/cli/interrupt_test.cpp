// Ctrl-C, and scenes that change under --watch.
#include "files.hpp"
#include "process.hpp"

#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <prelight/image.hpp>
#include <thread>

namespace prelight::test {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, MidRunLeavesNothing) {
    const TemporaryFolder folder;
    Prelight program(
        {"render", "spheres", "--size", "64x36", "--frames", "100000000", "-o", "a.png", "--stats", "a.json"},
        folder.path);
    std::this_thread::sleep_for(1s);
    ASSERT_TRUE(program.running()) << program.wait().err;
    program.send(GetParam());
    const Result result = program.wait();
    EXPECT_EQ(result.signal, GetParam());
    EXPECT_FALSE(result.timed_out);
    EXPECT_EQ(folder.entries(), 0u);
}
INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM, SIGHUP));

/// True while a file under a temporary name is there.
bool being_written(const fs::path& folder) {
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename() != "a.glb" && entry.file_size(gone) > 0 && !gone)
            return true;
    return false;
}

/// The folder is watched without a pause, so that the signal comes while the temporary file is
/// there. A write takes milliseconds and may be missed; rounds go on until some were not.
TEST(Interrupt, WhileWritingLeavesNoHalfFile) {
    int during_write = 0;
    for (int round = 0; round < 40 && during_write < 4; ++round) {
        const TemporaryFolder folder;
        Prelight program({"make", "lights", "--lights", "64", "-o", "a.glb"}, folder.path);
        bool seen = false;
        while (!seen && program.running())
            seen = being_written(folder.path);
        program.send(SIGINT);
        const Result result = program.wait();
        for (const auto& entry : fs::directory_iterator(folder.path))
            ASSERT_EQ(entry.path().filename(), "a.glb") << "half a file was left";
        if (!seen || result.signal == 0)
            continue; // it had finished before
        ++during_write;
        EXPECT_EQ(result.signal, SIGINT);
        // What was being written was finished first: it is a whole file.
        const std::string bytes = bytes_of(folder.path / "a.glb");
        ASSERT_GE(bytes.size(), 12u);
        uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 8, 4);
        EXPECT_EQ(length, bytes.size());
    }
    EXPECT_GT(during_write, 0) << "no signal came during a write: nothing was tested";
}

TEST(Watch, RendersAgainWhenTheFileChanges) {
    const TemporaryFolder folder;
    const auto make = [&](const char* lights) {
        EXPECT_TRUE(succeeded(run({"make", "lights", "--lights", lights, "-o", "s.glb"}, folder.path)));
    };
    make("4");
    Prelight program({"render", "s.glb", "--size", "64x36", "-o", "a.png", "--watch"}, folder.path);
    ASSERT_TRUE(eventually([&] { return fs::exists(folder.path / "a.png"); }));
    const std::string first = bytes_of(folder.path / "a.png");

    // A file that cannot be read is told and waited out.
    std::ofstream(folder.path / "s.glb") << "glTF";
    std::this_thread::sleep_for(1s);
    ASSERT_TRUE(program.running());
    EXPECT_TRUE(bytes_of(folder.path / "a.png") == first);

    make("400");
    EXPECT_TRUE(eventually([&] { return bytes_of(folder.path / "a.png") != first; }));
    EXPECT_EQ(load_png(folder.path / "a.png").width, 64u);
    program.send(SIGINT);
    const Result result = program.wait();
    EXPECT_EQ(result.signal, SIGINT);
    EXPECT_THAT(result.err, testing::HasSubstr("s.glb"));
}

} // namespace
} // namespace prelight::test
