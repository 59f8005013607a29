// --environment and what belongs to it.
#include "files.hpp"
#include "process.hpp"

#include <gmock/gmock.h>
#include <limits>
#include <prelight/image.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// A Radiance picture, flat, of grey light.
std::string radiance(int width, int height, char mantissa = '\x80') {
    std::string text =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
    for (int i = 0; i < width * height; ++i)
        text += {mantissa, mantissa, mantissa, '\x81'};
    return text;
}

std::vector<std::string> render_with(const std::vector<std::string>& more, const char* scene = "spheres") {
    return joined({"render", scene, "--size", "64x36", "--msaa", "1", "-o", "a.png"}, more);
}

TEST(Environment, EveryKindOfFileLightsTheSceneAndIsSeenBehindIt) {
    const TemporaryFolder folder;
    write(folder.path / "sky.hdr", radiance(8, 4));
    Image grey(8, 4);
    std::fill(grey.pixels.begin(), grey.pixels.end(), glm::vec3(1));
    save_exr(grey, folder.path / "sky.exr");
    save_png(grey, folder.path / "sky.png"); // white: 1 too
    Image first;
    for (const char* file : {"sky.hdr", "sky.exr", "sky.png"}) {
        ASSERT_TRUE(succeeded(run(render_with({"--environment", file, "--validate"}), folder.path))) << file;
        const Image picture = load_png(folder.path / "a.png");
        EXPECT_GT(picture.at(1, 1).r, 0.5) << "the sky shows";
        if (first.pixels.empty())
            first = picture;
        EXPECT_TRUE(picture.pixels == first.pixels) << file;
    }
    ASSERT_TRUE(succeeded(run(render_with({"--environment", "sky.hdr", "--background", "black"}), folder.path)));
    EXPECT_EQ(load_png(folder.path / "a.png").at(1, 1), glm::vec3(0));
    ASSERT_TRUE(succeeded(run(render_with({"--environment", "sky.hdr", "--environment-intensity", "0"}), folder.path)));
    EXPECT_EQ(load_png(folder.path / "a.png").at(1, 1), glm::vec3(0));
}

TEST(Environment, TurnsTheSky) {
    const TemporaryFolder folder;
    Image halves(8, 4);
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 8; ++x)
            halves.at(x, y) = x < 4 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    save_exr(halves, folder.path / "sky.exr");
    ASSERT_TRUE(succeeded(run(render_with({"--environment", "sky.exr"}), folder.path)));
    const Image before = load_png(folder.path / "a.png");
    ASSERT_TRUE(
        succeeded(run(render_with({"--environment", "sky.exr", "--environment-rotation", "180"}), folder.path)));
    const Image after = load_png(folder.path / "a.png");
    EXPECT_NE(before.at(1, 1).r > before.at(1, 1).b, after.at(1, 1).r > after.at(1, 1).b);
}

TEST(Environment, GoesWithCompareAndBenchToo) {
    const TemporaryFolder folder;
    write(folder.path / "sky.hdr", radiance(8, 4));
    EXPECT_TRUE(
        succeeded(run({"compare", "spheres", "-o", "report", "--size", "32x18", "--frames", "1", "--light-counts",
                       "none", "--renderers", "light-prepass,deferred", "--environment", "sky.hdr"},
                      folder.path)));
    EXPECT_TRUE(succeeded(
        run({"bench", "spheres", "--size", "32x18", "--frames", "1", "--environment", "sky.hdr"}, folder.path)));
    const Result table = run({"bench", "encodings", "--environment", "sky.hdr"}, folder.path);
    EXPECT_EQ(table.status, 2);
    EXPECT_THAT(table.err, HasSubstr("--environment: goes with bench SCENE only"));
}

TEST(Environment, WhatIsWrongIsOneLine) {
    const TemporaryFolder folder;
    const auto expect = [&](const std::vector<std::string>& more, int status, const char* text) {
        const Result result = run(render_with(more), folder.path);
        EXPECT_EQ(result.status, status) << text;
        EXPECT_THAT(result.err, HasSubstr(text));
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_FALSE(fs::exists(folder.path / "a.png"));
    };
    write(folder.path / "square.hdr", radiance(4, 4));
    write(folder.path / "short.hdr", radiance(8, 4).substr(0, 100));
    write(folder.path / "text.hdr", "no picture");
    write(folder.path / "sky.jpg", "no picture");
    Image bad(4, 2);
    bad.at(1, 1).g = -1;
    save_exr(bad, folder.path / "negative.exr");
    bad.at(1, 1).g = std::numeric_limits<float>::quiet_NaN();
    save_exr(bad, folder.path / "nan.exr");
    expect({"--environment", "none.hdr"}, 1, "none.hdr: cannot be opened");
    expect({"--environment", "sky.jpg"}, 1, "sky.jpg: an environment map ends in .hdr, .exr or .png");
    expect({"--environment", "square.hdr"}, 1,
           "square.hdr: an environment map is twice as wide as high, and this one has 4x4");
    expect({"--environment", "short.hdr"}, 1, "short.hdr: ends too early");
    expect({"--environment", "text.hdr"}, 1, "text.hdr: not a Radiance picture");
    expect({"--environment", "negative.exr"}, 1,
           "negative.exr: a pixel of the environment map is negative or not finite");
    expect({"--environment", "nan.exr"}, 1, "nan.exr: a pixel of the environment map is negative or not finite");
    expect({"--environment-intensity", "-1"}, 2, "--environment-intensity -1");
    expect({"--environment-rotation", "north"}, 2, "--environment-rotation north");
    expect({"--background", "sunset"}, 2, "--background sunset: not one of environment, backdrop, black");
    expect({"--environment-rotation", "90"}, 2, "--environment-rotation: spheres has no environment");
    expect({"--background", "black"}, 2, "--background: spheres has no environment");
}

TEST(Environment, OfTheSceneItselfCanBeTurned) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(render_with({}, "materials"), folder.path)));
    const Image before = load_png(folder.path / "a.png");
    ASSERT_TRUE(succeeded(run(render_with({"--environment-rotation", "90"}, "materials"), folder.path)));
    EXPECT_FALSE(load_png(folder.path / "a.png").pixels == before.pixels);
}

} // namespace
} // namespace prelight::test
