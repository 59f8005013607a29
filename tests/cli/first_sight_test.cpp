// What a file looks like when nothing is said about light, view and exposure.
#include "files.hpp"
#include "process.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <prelight/image.hpp>
#include <prelight/scene_io.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/shapes.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A box of these half sides, away from the origin; nothing else.
Scene box_scene(glm::vec3 half = {1, 0.5f, 0.25f}) {
    Scene scene;
    scene.name = "box";
    scene.materials.push_back({.name = "grey", .base_colour = {0.5f, 0.5f, 0.5f, 1}, .metallic = 0, .roughness = 0.6f});
    scene.scenes.emplace_back();
    add_root(scene, "box", translation({30, 2, -7})).mesh = add_mesh(scene, "box", make_box(-half, half), 0);
    return scene;
}

Light lamp(float intensity) { return {.name = "lamp", .kind = LightKind::point, .intensity = intensity}; }

class FirstSight : public testing::Test {
protected:
    void save(const Scene& scene, const char* name = "s.glb") { save_glb(scene, folder.path / name); }
    /// The picture of s.glb with these options more, and what the program said. One sample a pixel, as everywhere where
    /// they are not the matter: the pipelines of four take as long as all the rest of such a picture.
    Result render(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render", "s.glb", "-o", "a.png", "--msaa", "1"};
        if (std::find(more.begin(), more.end(), "--size") == more.end())
            arguments.insert(arguments.end(), {"--size", "96x54"});
        Result result = run(joined(arguments, more), folder.path);
        EXPECT_TRUE(succeeded(result));
        return result;
    }
    std::string picture(const std::vector<std::string>& more) {
        render(more);
        return bytes_of(folder.path / "a.png");
    }
    Image image() const { return load_png(folder.path / "a.png"); }
    TemporaryFolder folder;
};

TEST_F(FirstSight, AFileWithoutLightsStandsInTheStudio) {
    save(box_scene());
    const std::string plain = picture({});
    const Image shown = image();
    EXPECT_EQ(plain, picture({"--environment", "studio"}));
    const glm::vec3 corner = shown.at(1, 1);
    EXPECT_EQ(corner.r, corner.b) << "a neutral backdrop";
    EXPECT_GT(corner.r, 0.3f);
    EXPECT_LT(corner.r, 0.85f);
    EXPECT_NE(plain, picture({"--environment", "none"}));
    EXPECT_EQ(image().at(1, 1), glm::vec3(0)) << "the key light, on black";
    EXPECT_NE(plain, picture({"--background", "environment"})) << "the room itself";
    EXPECT_NE(plain, picture({"--background", "black"}));
    EXPECT_EQ(image().at(1, 1), glm::vec3(0));
    EXPECT_EQ(plain, picture({"--background", "backdrop"}));
    EXPECT_NE(plain, picture({"--environment-intensity", "0.5"})) << "its light can be changed without naming it";
}

TEST_F(FirstSight, TheStudioIsTheSameInEveryArchitecture) {
    save(box_scene());
    render({});
    const Image first = image();
    for (const char* renderer : {"deferred", "multipass", "z-prepass", "reference"}) {
        render({"--renderer", renderer});
        const Image other = image();
        size_t off = 0;
        for (size_t i = 0; i < first.pixels.size(); ++i)
            off += glm::length(first.pixels[i] - other.pixels[i]) > 4.0f / 255;
        EXPECT_LE(off, first.pixels.size() / 100) << renderer;
    }
}

TEST_F(FirstSight, WhatShinesAlreadyGetsNoStudio) {
    Scene scene = box_scene();
    save(scene);
    const std::string added = picture({"--lights", "3"});
    EXPECT_EQ(image().at(1, 1), glm::vec3(0)) << "added lights are lights";
    EXPECT_EQ(added, picture({"--lights", "3", "--environment", "none"}));
    EXPECT_NE(added, picture({"--lights", "3", "--environment", "studio"}));
    add_light(scene, lamp(20), {30, 4, -5});
    save(scene);
    const std::string lit = picture({});
    EXPECT_EQ(image().at(1, 1), glm::vec3(0));
    EXPECT_EQ(lit, picture({"--environment", "none"}));
    EXPECT_NE(lit, picture({"--environment", "studio"}));
    Scene ambient = box_scene();
    ambient.ambient = glm::vec3(0.3f);
    save(ambient);
    EXPECT_EQ(picture({}), picture({"--environment", "none"}));
    EXPECT_EQ(run({"render", "spheres", "--size", "32x18", "--msaa", "1", "-o", "a.png"}, folder.path).status, 0);
    EXPECT_EQ(image().at(0, 0), glm::vec3(0)) << "built-in scenes are as they are";
}

TEST_F(FirstSight, AnEnvironmentOfTheFilesOwnStaysUnlessTakenAway) {
    Scene scene = box_scene();
    Environment own = make_environment("studio");
    own.name = "own";
    own.intensity = 0.3f;
    scene.environment = std::make_shared<Environment>(own);
    save(scene);
    const std::string plain = picture({});
    EXPECT_NE(plain, picture({"--environment", "studio"}));
    EXPECT_EQ(plain, picture({"--environment-intensity", "0.3"}));
    const Image with = image();
    render({"--environment", "none"});
    EXPECT_EQ(image().at(1, 1), glm::vec3(0));
    EXPECT_NE(with.at(1, 1), glm::vec3(0)) << "and its backdrop was in the file";
}

/// Columns and rows of the picture that a surface covers.
struct Covered {
    double width, height;
};
/// For such a picture: of depth alone, unlit, for the reference's light of the studio is an integral at each pixel.
const std::vector<std::string> only_depth{"--renderer", "reference", "--view", "depth", "--environment", "none"};
Covered covered(const Image& depth) {
    uint32_t left = depth.width, right = 0, top = depth.height, bottom = 0;
    for (uint32_t y = 0; y < depth.height; ++y)
        for (uint32_t x = 0; x < depth.width; ++x)
            if (depth.at(x, y).r > 0) {
                left = std::min(left, x), right = std::max(right, x + 1);
                top = std::min(top, y), bottom = std::max(bottom, y + 1);
            }
    return {double(right - left) / depth.width, double(bottom - top) / depth.height};
}

TEST_F(FirstSight, FourFifthsOfThePictureAreFilled) {
    for (const glm::vec3& half : {glm::vec3(1, 0.5f, 0.25f), glm::vec3(0.2f, 3, 0.2f), glm::vec3(50, 1, 50)}) {
        save(box_scene(half));
        for (const char* size : {"320x180", "180x320", "200x200"})
            for (const auto& [fit, share] : {std::pair("0.8", 0.8), std::pair("0.5", 0.5)}) {
                render(joined(only_depth, {"--size", size, "--fit", fit}));
                const Covered found = covered(image());
                EXPECT_NEAR(std::max(found.width, found.height), share, 0.015) << size << " " << half.x;
            }
        render(joined(only_depth, {"--size", "320x180"}));
        const Covered found = covered(image());
        EXPECT_NEAR(std::max(found.width, found.height), 0.8, 0.015) << "the default";
    }
}

TEST_F(FirstSight, ViewFromTakesThePlaceOfACamera) {
    Scene scene = box_scene({1, 0.2f, 0.5f});
    save(scene);
    const std::string usual = picture({}), above = picture({"--view-from", "0,90"});
    EXPECT_NE(usual, above);
    EXPECT_EQ(usual, picture({"--view-from", "20,15"}));
    EXPECT_EQ(usual, picture({"--view-from", "20,15", "--fit", "0.8"}));
    add_camera(scene, {.name = "own", .yfov = 0.2}, {30, 2, 20}, {30, 2, -7});
    save(scene);
    EXPECT_NE(usual, picture({}));
    EXPECT_EQ(usual, picture({"--fit", "0.8"}));
    EXPECT_EQ(above, picture({"--view-from", "0,90"}));
    render(joined(only_depth, {"--view-from", "0,90", "--size", "300x200"}));
    const Covered top = covered(image());
    EXPECT_NEAR(top.width * 300 / (top.height * 200), 2, 0.05) << "2 m wide and 1 m deep, seen from above";
    render(joined(only_depth, {"--view-from", "90,0", "--size", "300x200"}));
    const Covered side = covered(image());
    EXPECT_LT(side.width * 300 / (side.height * 200), 2.6) << "1 m deep and 0.4 m high, from the right";
    EXPECT_EQ(run({"compare", "s.glb", "-o", "report", "--size", "32x18", "--frames", "1", "--light-counts", "none",
                   "--renderers", "light-prepass", "--view-from", "0,90", "--exposure", "auto"},
                  folder.path)
                  .status,
              0);
    EXPECT_EQ(run({"bench", "s.glb", "--size", "32x18", "--frames", "1", "--fit", "0.5"}, folder.path).status, 0);
}

TEST_F(FirstSight, AutoExposureIsPrintedAndCanBeGiven) {
    Scene scene = box_scene();
    add_light(scene, lamp(4000), {31, 5, -4});
    save(scene);
    const auto ev_of = [](const Result& result) {
        const size_t at = result.out.find("--exposure ");
        EXPECT_NE(at, std::string::npos) << result.out;
        return at == std::string::npos ? "" : result.out.substr(at + 11, result.out.find('\n', at) - at - 11);
    };
    const Result found = render({"--exposure", "auto"});
    const std::string ev = ev_of(found), bytes = bytes_of(folder.path / "a.png");
    EXPECT_LT(std::stod(ev), -3) << "a very bright lamp";
    EXPECT_EQ(bytes, picture({"--exposure=" + ev}));
    EXPECT_EQ(bytes, picture({"--exposure", "auto", "--frames", "3"})) << "as the first frame";
    for (const char* renderer : {"deferred", "multipass", "reference"})
        EXPECT_NEAR(std::stod(ev_of(render({"--exposure", "auto", "--renderer", renderer}))), std::stod(ev), 0.11)
            << renderer;
    scene.lights[0].intensity *= 1024;
    save(scene);
    EXPECT_NEAR(std::stod(ev_of(render({"--exposure", "auto"}))), std::stod(ev) - 10, 0.11);
    scene.lights[0].intensity = 4e-6f;
    save(scene);
    EXPECT_NEAR(std::stod(ev_of(render({"--exposure", "auto"}))), std::stod(ev) + std::log2(1e9), 0.21);
    render({"--exposure", "auto", "--stats", "a.json"});
    EXPECT_GT(nlohmann::json::parse(bytes_of(folder.path / "a.json")).at("exposure").get<double>(), 20);
}

TEST_F(FirstSight, AFileThatItsLightsBurnOutIsExposedByItself) {
    Scene scene = box_scene();
    add_light(scene, lamp(4000), {31, 5, -4});
    save(scene);
    const Result found = render({});
    const std::string bytes = bytes_of(folder.path / "a.png");
    EXPECT_THAT(found.out, testing::ContainsRegex("^exposure: auto is --exposure -[0-9]+\\.[0-9]\n"));
    EXPECT_THAT(found.out, Not(HasSubstr("environment:")));
    EXPECT_THAT(found.err, Not(HasSubstr("try --exposure auto")));
    EXPECT_THAT(render({"--exposure", "auto"}).out, testing::StartsWith(found.out.substr(0, found.out.find('\n'))));
    EXPECT_EQ(bytes, bytes_of(folder.path / "a.png"));
    const Result asked = render({"--exposure", "0"});
    EXPECT_THAT(asked.out, Not(HasSubstr("exposure:")));
    EXPECT_THAT(asked.err, HasSubstr("burnt out: try --exposure auto"));
    EXPECT_THAT(render({"--lights", "1"}).out, Not(HasSubstr("exposure:"))) << "not only the file's";
    EXPECT_THAT(render({"--view", "depth"}).out, Not(HasSubstr("exposure:")));
    const Result linear = run({"render", "s.glb", "--size", "96x54", "--msaa", "1", "-o", "a.exr"}, folder.path);
    EXPECT_THAT(linear.out, Not(HasSubstr("exposure:"))) << "light as it is";
}

TEST_F(FirstSight, AFileThatItsLightsLeaveBlackStandsInTheStudio) {
    Scene scene = box_scene();
    add_light(scene, lamp(0.001f), {31, 5, -4});
    save(scene);
    const Result found = render({});
    const std::string bytes = bytes_of(folder.path / "a.png");
    EXPECT_THAT(found.out, testing::ContainsRegex("^environment: studio, since the file's lights leave [0-9]+ % of the "
                                                  "picture black \\(--environment none keeps it so\\)\n"));
    EXPECT_THAT(found.out, Not(HasSubstr("exposure:")));
    EXPECT_EQ(found.err, "");
    EXPECT_EQ(bytes, picture({"--environment", "studio"}));
    EXPECT_EQ(bytes, picture({"--exposure", "0"})) << "of the environment nothing was said";
    EXPECT_THAT(render({"--exposure", "16"}).out, Not(HasSubstr("environment:"))) << "bright enough so";
    EXPECT_THAT(render({"--exposure", "auto"}).out, Not(HasSubstr("environment:")));
    EXPECT_NE(bytes, picture({"--environment", "none"}));
    render({"--background", "transparent"});
    const Image cut_out = image();
    render({"--background", "transparent", "--environment", "studio"});
    EXPECT_EQ(cut_out.pixels, image().pixels);
}

TEST_F(FirstSight, ManyPicturesHaveWhatTheFirstOneHas) {
    Scene scene = box_scene({0.1f, 0.1f, 0.1f});
    add_camera(scene, {.name = "far", .yfov = 0.3}, {30, 0, 0}, {30, 2, -7}); // little of the picture, and too bright
    add_light(scene, lamp(4000), {31, 5, -4});
    save(scene);
    const Result one = render({});
    const std::string lines = one.out.substr(0, one.out.find("a.png"));
    EXPECT_THAT(lines, HasSubstr("environment: studio"));
    EXPECT_THAT(lines, HasSubstr("exposure: auto is"));
    const std::string bytes = bytes_of(folder.path / "a.png");
    const Result many =
        run({"sequence", "s.glb", "-o", "f#.png", "--fps", "1", "--frames-at", "0,1", "--size", "96x54", "--msaa", "1"},
            folder.path);
    EXPECT_TRUE(succeeded(many));
    EXPECT_THAT(many.out, testing::StartsWith(lines));
    EXPECT_EQ(bytes_of(folder.path / "f1.png"), bytes);
    const Result compared = run({"compare", "s.glb", "-o", "report", "--size", "96x54", "--frames", "1",
                                 "--light-counts", "none", "--renderers", "light-prepass"},
                                folder.path);
    EXPECT_THAT(compared.out, testing::StartsWith(lines));
    const Image shown = load_png(folder.path / "report/pictures/light-prepass-final.png"), alone = image();
    for (size_t i = 0; i < alone.pixels.size(); ++i)
        ASSERT_LE(glm::length(shown.pixels[i] - alone.pixels[i]), 2.0f / 255);
    write(folder.path / "r.txt", "prelight view 1\nsize 96x54\n1 drop s.glb\n");
    const Result played = run({"view", "s.glb", "--play", "r.txt", "-o", "p.png"}, folder.path);
    EXPECT_THAT(played.out, testing::StartsWith(lines));
    EXPECT_EQ(bytes_of(folder.path / "p.png"), bytes) << "also when it is read again";
}

TEST_F(FirstSight, ABurntOutOrBlackPictureSaysSo) {
    Scene scene = box_scene();
    add_light(scene, lamp(0.001f), {31, 5, -4}); // far too little
    save(scene);
    const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
    const Result dark = render({"--environment", "none"});
    EXPECT_THAT(
        dark.err,
        testing::ContainsRegex(
            "^warning: a.png: [0-9]+ % of the pixels are black: try --environment studio, or --exposure auto\n$"));
    const Result burnt = render({"--exposure", "12", "--environment", "studio"});
    EXPECT_THAT(burnt.err, testing::ContainsRegex(
                               "^warning: a.png: [0-9]+ % of the pixels are burnt out: try --exposure auto\n$"));
    EXPECT_EQ(lines(burnt.err), 1);
    EXPECT_EQ(render({"--environment", "studio"}).err, "");
    EXPECT_EQ(render({"--view", "depth"}).err, "") << "only the final picture";
    const Result linear = run({"render", "s.glb", "--size", "96x54", "--msaa", "1", "-o", "a.exr", "--exposure", "12",
                               "--environment", "studio"},
                              folder.path);
    EXPECT_THAT(linear.err, HasSubstr("a.exr: "));
    EXPECT_THAT(linear.err, HasSubstr("burnt out"));
    const Result compared = run({"compare", "s.glb", "-o", "report", "--size", "32x18", "--frames", "1",
                                 "--light-counts", "none", "--renderers", "light-prepass"},
                                folder.path);
    EXPECT_THAT(compared.err, Not(HasSubstr("black")));
}

} // namespace
} // namespace prelight::test
