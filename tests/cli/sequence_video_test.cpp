// Sequences as videos: what ffmpeg is given, and what happens without it.
#include "files.hpp"
#include "process.hpp"

#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <image/display_bytes.hpp>
#include <prelight/image.hpp>

namespace prelight::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const Words scene{"sequence", "motion", "--size", "64x36", "--fps", "2"};

class VideoTest : public testing::Test {
protected:
    void SetUp() override {
        if (std::system("ffmpeg -version >/dev/null 2>&1") != 0)
            GTEST_SKIP() << "ffmpeg is not installed";
    }
    /// Runs a shell command in the folder and gives what it printed.
    std::string shell(const std::string& command) const {
        EXPECT_EQ(std::system(fmt::format("cd '{}' && {} >printed", folder.path.string(), command).c_str()), 0);
        return bytes_of(folder.path / "printed");
    }
    /// A program of this name that is found before any other.
    void put_on_path(const std::string& script) const {
        fs::create_directory(folder.path / "bin");
        write(folder.path / "bin/ffmpeg", "#!/bin/sh\n" + script);
        fs::permissions(folder.path / "bin/ffmpeg", fs::perms::owner_all);
    }
    Result run_with_that(const Words& words) const {
        const std::string path = (folder.path / "bin").string() + ":" + std::getenv("PATH");
        return run(words, folder.path, {}, {{"PATH", path}});
    }
    const TemporaryFolder folder;
};

TEST_F(VideoTest, MkvHoldsThePixelsOfThePngs) {
    ASSERT_TRUE(succeeded(run(joined(scene, {"-o", "v.mkv"}), folder.path)));
    ASSERT_TRUE(succeeded(run(joined(scene, {"-o", "s.#.png"}), folder.path)));
    std::string expected;
    for (int frame = 0; frame < 8; ++frame) {
        const std::vector<uint8_t> bytes = display_bytes(load_png(folder.path / fmt::format("s.{}.png", frame)));
        expected.append(bytes.begin(), bytes.end());
    }
    EXPECT_TRUE(shell("ffmpeg -v error -i v.mkv -f rawvideo -pix_fmt rgb24 -") == expected);
    const std::string first = bytes_of(folder.path / "v.mkv");
    ASSERT_TRUE(succeeded(run(joined(scene, {"-o", "v.mkv"}), folder.path)));
    EXPECT_TRUE(bytes_of(folder.path / "v.mkv") == first) << "two runs, two files";
}

TEST_F(VideoTest, Mp4SaysWhatItsColoursAre) {
    ASSERT_TRUE(succeeded(run(joined(scene, {"-o", "v.mp4", "--view", "depth=d.#.png"}), folder.path)));
    EXPECT_TRUE(fs::exists(folder.path / "d.7.png")) << "buffers beside a video are pictures";
    EXPECT_THAT(shell("ffprobe -v error -select_streams v -count_frames -show_streams v.mp4"),
                AllOf(HasSubstr("color_range=tv\n"), HasSubstr("color_space=bt709\n"),
                      HasSubstr("color_transfer=iec61966-2-1\n"), HasSubstr("color_primaries=bt709\n"),
                      HasSubstr("pix_fmt=yuv420p\n"), HasSubstr("width=64\n"), HasSubstr("height=36\n"),
                      HasSubstr("avg_frame_rate=2/1\n"), HasSubstr("nb_read_frames=8\n")));
    // The matrix is the one that the file names: decoded by it, colours are near the PNG's.
    ASSERT_TRUE(succeeded(run(joined(scene, {"--frames-at", "3", "-o", "s.#.png"}), folder.path)));
    shell("ffmpeg -v error -i v.mp4 -vf select=eq\\(n\\\\,3\\),scale=in_color_matrix=bt709 -frames:v 1 v.png");
    const Image video = load_png(folder.path / "v.png"), picture = load_png(folder.path / "s.3.png");
    glm::dvec3 difference(0);
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        difference += glm::dvec3(video.pixels[i]) - glm::dvec3(picture.pixels[i]);
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(difference[channel] / double(picture.pixels.size()), 0, 0.004);
}

TEST_F(VideoTest, WithoutFfmpegOneLineSaysSo) {
    const Result result = run(joined(scene, {"-o", "v.mp4"}), folder.path, {}, {{"PATH", folder.path.string()}});
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_THAT(result.err, HasSubstr("v.mp4: ffmpeg: is not on the PATH"));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST_F(VideoTest, AnFfmpegThatFailsLeavesNoFile) {
    for (const auto& [script, reason] :
         {std::pair("echo first >&2; echo 'no such encoder' >&2; exit 3\n", "ended with status 3 (no such encoder)"),
          std::pair("cat >/dev/null; echo 'disk full' >&2; exit 1\n", "ended with status 1 (disk full)"),
          std::pair("head -c 9000 >/dev/null; kill -9 $$\n", "was ended by signal 9")}) {
        SCOPED_TRACE(script);
        put_on_path(script);
        write(folder.path / "v.mkv", "from before");
        const Result result = run_with_that(joined(scene, {"-o", "v.mkv"}));
        EXPECT_TRUE(failed_with(result, 1));
        EXPECT_THAT(result.err, HasSubstr(std::string("v.mkv: ffmpeg: ") + reason));
        EXPECT_EQ(bytes_of(folder.path / "v.mkv"), "from before");
        EXPECT_EQ(folder.entries(), 2u) << "with bin";
    }
}

TEST_F(VideoTest, AnInterruptLeavesNothing) {
    Prelight program(
        {"sequence", "spheres", "--size", "64x36", "--frames-at", "0-99999", "-o", "v.mp4", "--view", "depth=d.#.png"},
        folder.path);
    ASSERT_TRUE(eventually([&] { return fs::exists(folder.path / "d.9.png"); }));
    program.send(SIGINT);
    EXPECT_EQ(program.wait().signal, SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(300)); // ffmpeg ends a little later
    for (const auto& entry : fs::directory_iterator(folder.path))
        EXPECT_EQ(entry.path().extension(), ".png") << entry.path();
}

TEST_F(VideoTest, AFailureOfTheSceneLeavesNothing) {
    write(folder.path / "bad.glb", "no glTF");
    EXPECT_TRUE(failed_with(run({"sequence", "bad.glb", "-o", "v.mkv"}, folder.path), 1));
    EXPECT_EQ(folder.entries(), 1u);
}

} // namespace
} // namespace prelight::test
