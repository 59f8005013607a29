// Ctrl-C, and scenes that change under --watch.
#include "process.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <prelight/image.hpp>
#include <sstream>
#include <thread>

namespace prelight::test {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

/// Waits until `condition` holds; false after 60 s.
bool eventually(const std::function<bool()>& condition) {
    for (const auto end = std::chrono::steady_clock::now() + 60s;
         std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(5ms))
        if (condition())
            return true;
    return false;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, MidRunLeavesNothing) {
    const TemporaryFolder folder;
    Prelight program({"render", "spheres", "--size", "64x36", "--frames", "100000000", "-o",
                      "a.png", "--stats", "a.json"},
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

/// At any moment of a run that writes a large picture: nothing, or the whole of it. The file system
/// is watched, so that some of the signals come while the temporary file is there.
TEST(Interrupt, WhileWritingLeavesNoHalfFile) {
    size_t during_write = 0;
    for (int round = 0; round < 6; ++round) {
        const TemporaryFolder folder;
        Prelight program({"make", "city", "--lights", "64", "-o", "a.glb"}, folder.path);
        // The first temporary file is the check before the work, the long one is the scene's.
        const bool seen = eventually([&] {
            std::error_code gone;
            for (const auto& entry : fs::directory_iterator(folder.path))
                if (entry.file_size(gone) > 0 || fs::exists(folder.path / "a.glb"))
                    return true;
            return !program.running();
        });
        ASSERT_TRUE(seen);
        during_write += !fs::exists(folder.path / "a.glb");
        program.send(SIGINT);
        program.wait();
        for (const auto& entry : fs::directory_iterator(folder.path))
            EXPECT_EQ(entry.path().filename(), "a.glb") << "half a file was left";
    }
    RecordProperty("interrupts_during_write", std::to_string(during_write));
}

TEST(Watch, RendersAgainWhenTheFileChanges) {
    const TemporaryFolder folder;
    const auto make = [&](const char* lights) {
        EXPECT_TRUE(
            succeeded(run({"make", "lights", "--lights", lights, "-o", "s.glb"}, folder.path)));
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
