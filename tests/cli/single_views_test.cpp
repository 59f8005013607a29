// Views of one blended layer, or of one sample of each pixel.
#include "files.hpp"
#include "process.hpp"

#include <gmock/gmock.h>

namespace prelight::test {
namespace {

TEST(SingleViews, AreOfOneLayer) {
    const TemporaryFolder folder;
    const auto render = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all{"render", "glass", "--size", "64x36", "--msaa", "1", "-o", "picture.png"};
        all.insert(all.end(), more.begin(), more.end());
        return run(all, folder.path);
    };
    ASSERT_TRUE(succeeded(render({"--view", "layer=1=first.png", "--view", "layer=2=second.png"})));
    EXPECT_FALSE(bytes_of(folder.path / "first.png") == bytes_of(folder.path / "second.png"));
    ASSERT_TRUE(succeeded(render({"--view", "layer=2"})));
    EXPECT_TRUE(bytes_of(folder.path / "picture.png") == bytes_of(folder.path / "second.png"));
    for (const char* view : {"layer=0", "layer=257=a.png", "layer=="}) {
        const Result result = render({"--view", view});
        EXPECT_TRUE(failed_with(result, 2));
        EXPECT_THAT(result.err, testing::StartsWith("prelight: --view "));
    }
}

TEST(SingleViews, AreOfOneSample) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run({"render", "spheres", "--size", "64x36", "--msaa", "4", "-o", "a.png", "--view",
                               "sample=0=first.png", "--view", "depth-sample=3=depth.png", "--view", "sample=3"},
                              folder.path)));
    EXPECT_FALSE(bytes_of(folder.path / "a.png") == bytes_of(folder.path / "first.png"));
    EXPECT_TRUE(std::filesystem::exists(folder.path / "depth.png"));
}

} // namespace
} // namespace prelight::test
