// Work that fails: exit status 1, one line that names the file, and nothing half done.
#include "files.hpp"
#include "process.hpp"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <prelight/image.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(Failure, AMissingFileIsNamed) {
    const TemporaryFolder folder;
    const Result result = run({"render", "no such.glb", "-o", "a.png"}, folder.path);
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_THAT(result.err, HasSubstr("no such.glb"));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(Failure, AnUnknownSceneNameListsTheBuiltinOnes) {
    const TemporaryFolder folder;
    const Result result = run({"render", "citty", "-o", "a.png"}, folder.path);
    EXPECT_TRUE(failed_with(result, 2));
    EXPECT_THAT(result.err, HasSubstr("city"));
}

TEST(Failure, AFolderIsNoScene) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path / "scene.glb");
    const Result result = run({"render", "scene.glb", "-o", "a.png"}, folder.path);
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Failure, ANewlineInAFileNameStaysOneLine) {
    const TemporaryFolder folder;
    EXPECT_TRUE(failed_with(run({"render", "a\nb.glb", "-o", "a.png"}, folder.path), 1));
}

TEST(Failure, AnOutputFolderMustExistBeforeAnyWork) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& outputs : {std::vector<std::string>{"-o", "no/a.png"},
                                                    {"-o", "a.png", "--stats", "no/a.json"},
                                                    {"-o", "a.png", "--view", "depth=no/d.png"}}) {
        // A frame count that would take hours shows that the check comes first.
        const Result result = run(joined({"render", "lights", "--frames", "1000000"}, outputs), folder.path);
        EXPECT_TRUE(failed_with(result, 1));
        EXPECT_THAT(result.err, HasSubstr("no/"));
    }
    const Result made = run({"make", "spheres", "-o", "no/a.glb"}, folder.path);
    EXPECT_TRUE(failed_with(made, 1));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(Failure, AnOutputMayNotBeAFolder) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path / "a.png");
    EXPECT_TRUE(failed_with(run({"render", "spheres", "-o", "a.png"}, folder.path), 1));
    EXPECT_TRUE(fs::is_directory(folder.path / "a.png"));
}

class BeyondTheLimit : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(BeyondTheLimit, SizeIsRefused) {
    const auto [renderer, size] = GetParam();
    const TemporaryFolder folder;
    const Result result =
        run({"render", "spheres", "-o", "a.png", "--renderer", renderer, "--size", size}, folder.path);
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_LT(result.peak_bytes, uint64_t(2) << 30);
    EXPECT_EQ(folder.entries(), 0u);
}
INSTANTIATE_TEST_SUITE_P(Sizes, BeyondTheLimit,
                         testing::Combine(testing::Values("light-prepass", "reference"),
                                          testing::Values("4294967295x4294967295", "1000000x1000000", "2000000000x1")));

TEST(Failure, AFailureLeavesTheOldPictureAlone) {
    const TemporaryFolder folder;
    write(folder.path / "a.png", "the old picture");
    write(folder.path / "bad.glb", "glTF\2\0\0\0");
    EXPECT_TRUE(failed_with(run({"render", "bad.glb", "-o", "a.png"}, folder.path), 1));
    std::ifstream stream(folder.path / "a.png");
    std::string text;
    std::getline(stream, text);
    EXPECT_EQ(text, "the old picture");
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(Failure, AFullDiskIsReported) {
    if (!fs::exists("/dev/full"))
        GTEST_SKIP() << "no /dev/full here";
    // stdout cannot be redirected by the process helper, so a shell does it.
    const TemporaryFolder folder;
    const std::string command = std::string("'") + PRELIGHT_PROGRAM + "' renderers >/dev/full 2>/dev/null";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
}

/// Every way of cutting a good file short, and of breaking a byte of its start.
TEST(Failure, ATruncatedFileIsRefused) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run({"make", "spheres", "-o", "good.glb"}, folder.path)));
    const std::string good = bytes_of(folder.path / "good.glb");
    for (const size_t size :
         {size_t(0), size_t(3), size_t(12), size_t(19), good.size() / 100, good.size() / 2, good.size() - 5}) {
        write(folder.path / "cut.glb", std::string_view(good).substr(0, size));
        const Result result = run({"render", "cut.glb", "-o", "a.png", "--renderer", "reference"}, folder.path);
        EXPECT_TRUE(failed_with(result, 1)) << size << " bytes";
        EXPECT_THAT(result.err, HasSubstr("cut.glb"));
    }
    EXPECT_EQ(folder.entries(), 2u);
}

/// 0 or 1, in bounded time and memory; a picture only with 0, and then a whole one.
void expect_bounded(const fs::path& scene, const char* renderer) {
    const TemporaryFolder folder;
    const Limits limits = {.seconds = 60, .address_space = address_sanitizer ? 0 : uint64_t(16) << 30};
    std::vector<std::string> arguments{"render", scene.string(), "-o",         "a.png",
                                       "--size", "64x36",        "--renderer", renderer};
    if (renderer == std::string_view("reference")) // whose light of the studio takes long
        arguments.insert(arguments.end(), {"--msaa", "1", "--environment", "none"});
    const Result result = run(arguments, folder.path, limits);
    SCOPED_TRACE(scene.filename().string() + " with " + renderer);
    if (result.status == 0) {
        EXPECT_TRUE(succeeded(result));
        EXPECT_EQ(load_png(folder.path / "a.png").width, 64u);
    } else {
        EXPECT_TRUE(failed_with(result, 1));
        EXPECT_EQ(folder.entries(), 0u);
    }
    EXPECT_LT(result.peak_bytes, uint64_t(address_sanitizer ? 4096 : 1024) << 20);
}

TEST(Failure, DamagedFilesOfOtherHandsEndInBoundedTimeAndMemory) {
    const fs::path damaged = fs::path(PRELIGHT_SHARED_SCENES) / "damaged";
    if (!fs::exists(damaged))
        GTEST_SKIP() << "the shared scenes are not on this machine";
    std::vector<fs::path> scenes;
    for (const auto& entry : fs::recursive_directory_iterator(damaged))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
            scenes.push_back(entry.path());
    std::ranges::sort(scenes);
    ASSERT_GE(scenes.size(), 15u);
    for (const fs::path& scene : scenes) {
        expect_bounded(scene, "reference");
        expect_bounded(scene, "light-prepass");
    }
}

} // namespace
} // namespace prelight::test
