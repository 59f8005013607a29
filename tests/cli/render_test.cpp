// What a successful run leaves behind.
#include "files.hpp"
#include "process.hpp"
#include "spread.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <prelight/image.hpp>

namespace prelight::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// As somebody types it who says nothing of samples: four a pixel.
std::vector<std::string> smoothed_render(const std::vector<std::string>& more) {
    return joined({"render", "spheres", "--size", "64x36"}, more);
}

std::vector<std::string> small_render(const std::vector<std::string>& more) {
    return joined(smoothed_render({"--msaa", "1"}), more);
}

/// Mean of all channels, and how far the values spread around it.
std::pair<double, double> mean_and_deviation(const Image& image) {
    double sum = 0, squares = 0;
    for (const glm::vec3& pixel : image.pixels)
        for (int c = 0; c < 3; ++c) {
            sum += pixel[c];
            squares += double(pixel[c]) * pixel[c];
        }
    const double count = 3.0 * double(image.pixels.size()), mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

TEST(Render, WritesAPngOfTheSizeAskedForWithSomethingOnIt) {
    const TemporaryFolder folder;
    const Result result = run(smoothed_render({"-o", "a.png"}), folder.path);
    ASSERT_TRUE(succeeded(result));
    EXPECT_THAT(result.out, HasSubstr("a.png: 64x36, light-prepass"));
    const Image image = load_png(folder.path / "a.png");
    EXPECT_EQ(image.width, 64u);
    EXPECT_EQ(image.height, 36u);
    EXPECT_GT(mean_and_deviation(image).second, 0.02) << "flat picture";
    EXPECT_EQ(folder.entries(), 1u) << "a temporary file was left";
}

TEST(Render, TwoRunsGiveTheSameBytes) {
    const TemporaryFolder folder;
    for (const char* renderer : {"light-prepass", "reference"}) {
        ASSERT_TRUE(succeeded(run(smoothed_render({"-o", "a.png", "--renderer", renderer}), folder.path)));
        ASSERT_TRUE(succeeded(run(smoothed_render({"-o", "b.png", "--renderer", renderer}), folder.path)));
        EXPECT_TRUE(bytes_of(folder.path / "a.png") == bytes_of(folder.path / "b.png")) << renderer;
    }
}

TEST(Render, TheReferenceTakesSeveralSamplesAPixel) {
    const TemporaryFolder folder;
    const auto picture = [&](const std::vector<std::string>& more) {
        const Result result =
            run(joined(smoothed_render({"-o", "a.png", "--renderer", "reference"}), more), folder.path);
        EXPECT_TRUE(succeeded(result));
        return bytes_of(folder.path / "a.png");
    };
    const std::string one = picture({}), four = picture({"--msaa", "4", "--stats", "a.json"});
    EXPECT_TRUE(one == picture({"--msaa", "1"}));
    EXPECT_TRUE(one != four);
    EXPECT_TRUE(four != picture({"--msaa", "2"}));
    EXPECT_TRUE(four != picture({"--msaa", "4", "--set", "msaa-light=pixel", "--set", "msaa-material=fragment"}));
    const Json stats = Json::parse(bytes_of(folder.path / "a.json"));
    EXPECT_EQ(stats.at("msaa"), 4);
    EXPECT_EQ(stats.at("settings").at("msaa-light"), "samples");
}

TEST(Render, SmoothsEdgesUnlessToldOtherwise) {
    const TemporaryFolder folder;
    struct Case {
        std::vector<std::string> said;
        uint32_t samples;
        const char* filter;
    };
    const Case cases[] = {{{}, 4, "none"},
                          {{"--renderer", "z-prepass"}, 4, "none"},
                          {{"--set", "light-culling=volumes"}, 4, "none"},
                          {{"--msaa", "1"}, 1, "none"},
                          {{"--msaa", "4"}, 4, "none"},
                          {{"--set", "antialiasing=none"}, 1, "none"},
                          {{"--set", "antialiasing=edge-blur"}, 1, "edge-blur"},
                          // These would give way to samples.
                          {{"--set", "depth=r32f"}, 1, "smaa"},
                          {{"--renderer", "deferred", "--set", "ssao=half"}, 1, "smaa"},
                          // A source text's own way.
                          {{"--preset", "engel"}, 1, "none"}};
    for (const Case& one : cases) {
        SCOPED_TRACE(testing::PrintToString(one.said));
        ASSERT_TRUE(
            succeeded(run(joined(smoothed_render({"-o", "a.png", "--stats", "a.json"}), one.said), folder.path)));
        const Json stats = Json::parse(bytes_of(folder.path / "a.json"));
        EXPECT_EQ(stats.at("msaa"), one.samples);
        EXPECT_EQ(stats.at("settings").at("antialiasing"), one.filter);
    }
    ASSERT_TRUE(succeeded(run(smoothed_render({"-o", "a.png"}), folder.path)));
    ASSERT_TRUE(succeeded(run(smoothed_render({"-o", "b.png", "--msaa", "4"}), folder.path)));
    EXPECT_TRUE(bytes_of(folder.path / "a.png") == bytes_of(folder.path / "b.png"));
}

TEST(Render, TimeAndAnimationPickThePose) {
    const TemporaryFolder folder;
    const auto picture = [&](const std::vector<std::string>& more) {
        const std::vector<std::string> motion = {"render", "motion", "--size",     "64x36",
                                                 "-o",     "a.png",  "--renderer", "reference"};
        EXPECT_TRUE(succeeded(run(joined(motion, more), folder.path)));
        return bytes_of(folder.path / "a.png");
    };
    const std::string rest = picture({}), half = picture({"--time", "0.5"});
    EXPECT_TRUE(rest != half);
    EXPECT_TRUE(half == picture({"--time", "0.5"}));
    EXPECT_TRUE(half != picture({"--time", "0.75"}));
    EXPECT_TRUE(picture({"--time", "9"}) == picture({"--time", "4"})) << "it stops at its end";
    const std::string bend = picture({"--time", "0.5", "--animation", "bend"});
    EXPECT_TRUE(bend != half && bend != rest);
    EXPECT_TRUE(bend == picture({"--time", "0.5", "--animation", "1"}));
    EXPECT_TRUE(picture({"--animation", "bend"}) == picture({"--animation", "bend", "--time", "0"}));
}

TEST(Render, ExrStaysLinear) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(small_render({"-o", "a.exr"}), folder.path)));
    ASSERT_TRUE(succeeded(run(small_render({"-o", "b.exr", "--tonemap", "none"}), folder.path)));
    ASSERT_TRUE(succeeded(run(small_render({"-o", "c.exr", "--exposure", "1"}), folder.path)));
    EXPECT_TRUE(bytes_of(folder.path / "a.exr") == bytes_of(folder.path / "b.exr"));
    const Image once = load_exr(folder.path / "a.exr"), twice = load_exr(folder.path / "c.exr");
    ASSERT_GT(mean_and_deviation(once).first, 0);
    EXPECT_NEAR(mean_and_deviation(twice).first / mean_and_deviation(once).first, 2, 0.01);
}

TEST(Render, TonemapAndShadingAndExposureChangeThePicture) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(small_render({"-o", "a.png"}), folder.path)));
    for (const auto& [key, value] :
         {std::pair{"--tonemap", "aces"}, {"--tonemap", "none"}, {"--shading", "phong"}, {"--exposure", "-1.5"}}) {
        ASSERT_TRUE(succeeded(run(small_render({"-o", "b.png", key, value}), folder.path))) << key;
        EXPECT_FALSE(bytes_of(folder.path / "a.png") == bytes_of(folder.path / "b.png")) << value;
    }
}

TEST(Render, WritesEveryBufferOfOneFrame) {
    const TemporaryFolder folder;
    ASSERT_TRUE(
        succeeded(run(small_render({"-o", "final.png", "--view", "depth=depth.png", "--view", "normal=normal.png",
                                    "--view", "diffuse-light=diffuse.png", "--view", "specular-light=specular.png"}),
                      folder.path)));
    EXPECT_EQ(folder.entries(), 5u);
    std::vector<std::string> seen;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path)) {
        const Image image = load_png(entry.path());
        EXPECT_EQ(image.width, 64u);
        EXPECT_GT(mean_and_deviation(image).second, 0.004) << entry.path() << " is flat";
        for (const std::string& other : seen)
            EXPECT_FALSE(bytes_of(entry.path()) == other) << entry.path() << " is another one's copy";
        seen.push_back(bytes_of(entry.path()));
    }
    // The same buffer in place of the picture.
    ASSERT_TRUE(succeeded(run(small_render({"-o", "alone.png", "--view", "depth"}), folder.path)));
    EXPECT_TRUE(bytes_of(folder.path / "alone.png") == bytes_of(folder.path / "depth.png"));
}

TEST(Render, StatsHoldWhatTheContractNames) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run({"render", "lights", "--lights", "16", "--size", "64x36", "-o", "a.png", "--frames", "3",
                               "--stats", "a.json", "--count-pairs", "--msaa", "1"},
                              folder.path)));
    const Json stats = Json::parse(bytes_of(folder.path / "a.json"));
    EXPECT_NE(stats.at("device").get<std::string>(), "");
    EXPECT_NE(stats.at("driver").get<std::string>(), "");
    EXPECT_EQ(stats.at("scene"), "lights");
    EXPECT_EQ(stats.at("renderer"), "light-prepass");
    EXPECT_TRUE(stats.at("preset").is_null());
    EXPECT_TRUE(stats.at("settings").is_object());
    EXPECT_GE(stats.at("settings").size(), 1u);
    EXPECT_EQ(stats.at("choices").at(0).at("setting"), "index-trimming");
    EXPECT_EQ(stats.at("choices").at(0).at("asked"), "auto");
    EXPECT_TRUE(stats.at("choices").at(0).at("why").is_string());
    EXPECT_EQ(stats.at("size"), Json({64, 36}));
    EXPECT_EQ(stats.at("msaa"), 1);
    EXPECT_EQ(stats.at("shading"), "ggx");
    EXPECT_EQ(stats.at("lights"), 16);
    EXPECT_EQ(stats.at("triangles"), 250284); // as the issue defines the scene
    EXPECT_GT(stats.at("draws"), 0);
    EXPECT_GT(stats.at("triangles_drawn"), 0);
    EXPECT_LE(stats.at("triangles_drawn"), stats.at("triangles"));
    for (const char* key : {"draws_skipped", "triangles_skipped"})
        EXPECT_TRUE(stats.at(key).is_null()) << key << ": nothing looks for it by default";
    EXPECT_EQ(stats.at("frames"), 3);
    for (const char* key : {"wall_ms", "cpu_ms", "gpu_ms"})
        expect_spread(stats.at(key));
    EXPECT_GT(stats.at("wall_ms").at("median"), 0);
    ASSERT_GE(stats.at("passes").size(), 3u) << "depth and normals, light, material";
    for (const Json& pass : stats.at("passes")) {
        EXPECT_NE(pass.at("name").get<std::string>(), "");
        expect_spread(pass.at("gpu_ms"));
        EXPECT_TRUE(pass.at("cpu_ms").is_null()) << "not asked for";
    }
    EXPECT_GT(stats.at("attachment_bytes"), 64 * 36 * 8);
    EXPECT_GE(stats.at("device_bytes"), stats.at("attachment_bytes"));
    EXPECT_GT(stats.at("light_pixel_pairs").at("evaluated"), 0);
    EXPECT_LE(stats.at("light_pixel_pairs").at("contributing"), stats.at("light_pixel_pairs").at("evaluated"));
    EXPECT_GE(stats.at("attachment_bytes_unshared"), 64 * 36 * 8);
    EXPECT_GE(stats.at("device_bytes_peak"), stats.at("device_bytes"));
    for (const char* key : {"allocations", "pipelines", "buffers", "images", "descriptor_pools"})
        EXPECT_EQ(stats.at("steady_frame").at(key), 0) << key;
    for (const char* key : {"lights", "culling", "objects", "record"})
        expect_spread(stats.at("host_ms").at(key));
    EXPECT_GT(stats.at("host_ms").at("record").at("min"), 0);
    double sum = 0;
    for (const char* key : {"device", "scene", "world", "frames", "picture"})
        sum += stats.at("start_up_ms").at(key).get<double>();
    EXPECT_GT(sum, 0);
    EXPECT_NEAR(stats.at("start_up_ms").at("total").get<double>(), sum, 1e-6);
    EXPECT_EQ(stats.at("exposure"), 0);
    EXPECT_EQ(stats.at("notes"), Json::array());
    EXPECT_EQ(stats.at("warnings"), Json::array());
    EXPECT_EQ(stats.at("updated_bytes"), 0) << "nothing of the world changes";
    EXPECT_GT(stats.at("frame_bytes"), 0);
    EXPECT_EQ(stats.size(), 34u) << "a key that the contract does not name";
}

TEST(Render, StatsTellOfShadowsWhereThereAreAny) {
    const TemporaryFolder folder;
    const Result result = run({"render", "shadows", "--size", "64x36", "--set", "shadows=on", "--set",
                               "shadow-budget=512", "-o", "a.png", "--stats", "a.json"},
                              folder.path);
    ASSERT_EQ(result.status, 0) << result.err;
    const Json shadows = Json::parse(bytes_of(folder.path / "a.json")).at("shadows");
    EXPECT_EQ(shadows.at("budget"), 512);
    EXPECT_EQ(shadows.at("lights"), 4);
    EXPECT_GE(shadows.at("lights_reduced"), 2);
    EXPECT_EQ(shadows.at("lights_without"), 0);
    EXPECT_EQ(shadows.at("tiles_drawn"), 17); // 4 cascades, two cubes, a spot
    EXPECT_NE(result.err.find(" of 4 lights have shadow maps with less than a texel for eight pixels across"),
              std::string::npos)
        << result.err;
}

TEST(Render, ShadowsThatFitAreNotWorthANote) {
    const TemporaryFolder folder;
    for (const auto& [scene, lights] : {std::pair("shadows", "4"), {"lights", "16"}, {"city", "64"}}) {
        const Result result = run({"render", scene, "--lights", lights, "--size", "64x36", "--msaa", "1", "--set",
                                   "shadows=on", "-o", "a.png"},
                                  folder.path);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err.find("shadow"), std::string::npos) << scene << ": " << result.err;
    }
}

TEST(Render, PassCpuGivesEachPassAFigure) {
    const TemporaryFolder folder;
    ASSERT_TRUE(
        succeeded(run(small_render({"-o", "a.png", "--frames", "3", "--stats", "a.json", "--pass-cpu"}), folder.path)));
    const Json stats = Json::parse(bytes_of(folder.path / "a.json"));
    for (const Json& pass : stats.at("passes"))
        expect_spread(pass.at("cpu_ms"));
}

TEST(Render, SettingsAndPresetsReachTheStats) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(
        run(small_render({"-o", "a.png", "--stats", "a.json", "--set", "normals=oct32", "--shading", "phong"}),
            folder.path)));
    const Json stats = Json::parse(bytes_of(folder.path / "a.json"));
    EXPECT_EQ(stats.at("settings").at("normals"), "oct32");
    EXPECT_EQ(stats.at("shading"), "phong");
}

TEST(Render, APresetShadesAsItsTextAndWhatItsLightBufferLosesIsTold) {
    const TemporaryFolder folder;
    const auto stats_of = [&](std::vector<std::string> more) {
        const std::vector<std::string> rest = {"-o", "a.png", "--stats", "a.json", "--preset", "prelighting"};
        more.insert(more.begin(), rest.begin(), rest.end());
        const Result result = run(small_render(more), folder.path);
        EXPECT_EQ(result.status, 0) << result.err;
        return std::pair(Json::parse(bytes_of(folder.path / "a.json")), result.err);
    };
    const auto [automatic, quiet] = stats_of({});
    EXPECT_EQ(automatic.at("shading"), "phong");
    EXPECT_EQ(automatic.at("settings").at("light-scale"), "auto");
    EXPECT_GT(automatic.at("light_buffer").at("diffuse_scale"), 0);
    EXPECT_EQ(automatic.at("notes"), Json::array());
    EXPECT_THAT(quiet, Not(HasSubstr("note: ")));
    const auto [fixed, told] = stats_of({"--set", "light-scale=0.02", "--shading", "ggx"});
    EXPECT_EQ(fixed.at("shading"), "ggx");
    EXPECT_GT(fixed.at("light_buffer").at("clipped_pixels"), 0);
    EXPECT_THAT(told, HasSubstr("note: light-scale: "));
    EXPECT_EQ(fixed.at("notes").size(), 1u);
}

TEST(Render, LightsAreAddedToAFileAndSetForABuiltin) {
    const TemporaryFolder folder;
    const auto lights = [&](const std::vector<std::string>& scene) {
        const std::vector<std::string> rest = {"--size",     "64x36",     "-o",      "a.png",
                                               "--renderer", "reference", "--stats", "a.json"};
        EXPECT_TRUE(succeeded(run(joined(joined({"render"}, scene), rest), folder.path)));
        return Json::parse(bytes_of(folder.path / "a.json")).at("lights").get<int>();
    };
    EXPECT_EQ(lights({"lights", "--lights", "5"}), 5);
    ASSERT_TRUE(succeeded(run({"make", "lights", "--lights", "5", "-o", "l.glb"}, folder.path)));
    EXPECT_EQ(lights({"l.glb"}), 5);
    EXPECT_EQ(lights({"l.glb", "--lights", "7"}), 12);
}

TEST(Render, AFileShowsWhatTheBuiltinSceneShows) {
    const TemporaryFolder folder;
    for (const char* name : {"spheres", "lights", "city"}) {
        ASSERT_TRUE(succeeded(run({"make", name, "--lights", "8", "--seed", "3", "-o", "s.glb"}, folder.path)));
        ASSERT_TRUE(
            succeeded(run({"render", "s.glb", "--size", "64x36", "--msaa", "1", "-o", "file.png"}, folder.path)));
        ASSERT_TRUE(succeeded(
            run({"render", name, "--lights", "8", "--seed", "3", "--size", "64x36", "--msaa", "1", "-o", "builtin.png"},
                folder.path)));
        const Image file = load_png(folder.path / "file.png"), builtin = load_png(folder.path / "builtin.png");
        ASSERT_EQ(file.pixels.size(), builtin.pixels.size());
        // What glTF cannot say to the last bit may move an edge, never more.
        size_t different = 0;
        for (size_t i = 0; i < file.pixels.size(); ++i)
            different +=
                glm::any(glm::greaterThan(glm::abs(file.pixels[i] - builtin.pixels[i]), glm::vec3(2.5f / 255)));
        EXPECT_LE(different, file.pixels.size() / 200) << name;
    }
}

TEST(Render, MakeGivesTheSameBytesForTheSameSeed) {
    const TemporaryFolder folder;
    const auto make = [&](const char* seed, const char* file) {
        EXPECT_TRUE(succeeded(run({"make", "lights", "--lights", "9", "--seed", seed, "-o", file}, folder.path)));
        return bytes_of(folder.path / file);
    };
    const std::string first = make("7", "a.glb");
    EXPECT_TRUE(first == make("7", "b.glb"));
    EXPECT_FALSE(first == make("8", "c.glb"));
    EXPECT_EQ(first.substr(0, 4), "glTF");
}

TEST(Render, CamerasByNameAndIndex) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(small_render({"-o", "a.png"}), folder.path)));
    ASSERT_TRUE(succeeded(run(small_render({"-o", "b.png", "--camera", "0"}), folder.path)));
    EXPECT_TRUE(bytes_of(folder.path / "a.png") == bytes_of(folder.path / "b.png"));
}

TEST(Render, ReferenceNeedsNoDevice) {
    const TemporaryFolder folder;
    const Result result = run(small_render({"-o", "a.png", "--renderer", "reference"}), folder.path, {},
                              {{"VK_DRIVER_FILES", "/nonexistent.json"}, {"VK_ICD_FILENAMES", "/nonexistent.json"}});
    ASSERT_TRUE(succeeded(result));
    EXPECT_GT(mean_and_deviation(load_png(folder.path / "a.png")).second, 0.02);
}

TEST(Render, ValidationHasNothingToSay) {
    if (!std::filesystem::exists(PRELIGHT_BUILD_DIR "/share/prelight/layers"))
        GTEST_SKIP() << "the chromium package's validation layer is not installed";
    const TemporaryFolder folder;
    const Result result =
        run({"render", "lights", "--lights", "16", "--size", "64x36", "--frames", "3", "-o", "a.png", "--view",
             "depth=d.png", "--view", "normal=n.png", "--view", "diffuse-light=l.png", "--validate"},
            folder.path);
    EXPECT_TRUE(succeeded(result));
    EXPECT_TRUE(std::filesystem::exists(folder.path / "a.png"));
}

} // namespace
} // namespace prelight::test
