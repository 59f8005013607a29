// Cookies, profiles and sizes of lights in glTF: read, written, and refused where they are wrong.
#include "gltf_builder.hpp"
#include <fstream>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

using namespace prelight::test;
using testing::HasSubstr;
using testing::StartsWith;

const std::string ies = "IESNA91\nTILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 0\n0 90\n0\n400 100\n";

/// Images of 1×1, 2×1, 6×1 and 3×1 texels as textures 0 … 3; light 0 with these extras.
GltfBuilder with_light(const Json& light, const Json& own) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["textures"] = Json::array();
    for (const uint32_t width : {1u, 2u, 6u, 3u}) {
        const size_t image = b.add_image(png(width, 1, solid(width, 1, {uint8_t(10 * width), 9, 9, 255})));
        b.json["textures"].push_back({{"source", image}});
    }
    Json entry = light;
    entry["extras"]["prelight"] = own;
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({entry});
    b.json["nodes"][0]["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
    return b;
}

const Json point{{"type", "point"}}, sun{{"type", "directional"}}, spot{{"type", "spot"}};

Json cookie(int texture) { return {{"cookie", {{"texture", {{"index", texture}}}}}}; }

TEST(GltfLightDistributions, ReadsCookiesProfilesAndSizes) {
    const Scene scene = with_light(spot, {{"cookie", {{"texture", {{"index", 3}}}}},
                                          {"ies", "data:;base64," + base64({ies.begin(), ies.end()})},
                                          {"size", 0.2}})
                            .load();
    const Light& light = scene.lights.at(0);
    ASSERT_LT(light.cookie, scene.images.size());
    EXPECT_EQ(scene.images[light.cookie].width, 3u);
    ASSERT_TRUE(light.profile);
    EXPECT_EQ(light.profile->largest, 400);
    EXPECT_FALSE(light.profile_candela);
    EXPECT_EQ(largest_intensity(light), 1);
    EXPECT_EQ(light.size, 0.2f);
    EXPECT_EQ(cookie_kind(scene, light), CookieKind::spot);
    EXPECT_EQ(cookie_kind(with_light(point, cookie(1)).load(), with_light(point, cookie(1)).load().lights[0]),
              CookieKind::sphere);
    const Scene cube = with_light(point, cookie(2)).load();
    EXPECT_EQ(cookie_kind(cube, cube.lights[0]), CookieKind::cube);
    EXPECT_EQ(with_light(point, Json::object()).load().lights[0].cookie, no_cookie);
}

TEST(GltfLightDistributions, FilesBesideTheSceneAndViewsAreReadOnce) {
    const TemporaryFolder folder;
    GltfBuilder b = with_light(point, {{"ies", {{"uri", "a%20lamp.ies"}, {"candela", true}}}});
    Json& lights = b.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(lights[0]);
    lights.push_back({{"type", "spot"},
                      {"extras", {{"prelight", {{"ies", {{"bufferView", b.add_view({ies.begin(), ies.end()})}}}}}}}});
    std::ofstream(folder.path / "a lamp.ies") << ies;
    const Bytes bytes = b.gltf();
    std::ofstream(folder.path / "a.gltf", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    const Scene scene = load_gltf(folder.path / "a.gltf");
    EXPECT_EQ(scene.lights[0].profile, scene.lights[1].profile);
    EXPECT_TRUE(scene.lights[0].profile_candela);
    EXPECT_EQ(largest_intensity(scene.lights[0]), 400);
    ASSERT_TRUE(scene.lights[2].profile);
    EXPECT_EQ(scene.lights[2].profile->text, ies);

    save_glb(scene, folder.path / "b.glb");
    const Scene again = load_gltf(folder.path / "b.glb");
    for (size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(again.lights[i].profile);
        EXPECT_EQ(again.lights[i].profile->text, ies);
        EXPECT_EQ(again.lights[i].profile->candela, scene.lights[i].profile->candela);
        EXPECT_EQ(again.lights[i].profile_candela, scene.lights[i].profile_candela);
    }
    EXPECT_EQ(again.lights[0].profile, again.lights[1].profile);
}

TEST(GltfLightDistributions, TheBuiltInSceneSurvivesWriting) {
    const TemporaryFolder folder;
    const Scene scene = make_scene("cookies", 10, 3);
    save_glb(scene, folder.path / "a.glb");
    const Scene again = load_gltf(folder.path / "a.glb");
    ASSERT_EQ(again.lights.size(), scene.lights.size());
    size_t cookies = 0, profiles = 0;
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        const Light &a = scene.lights[i], &b = again.lights[i];
        ASSERT_EQ(a.cookie == no_cookie, b.cookie == no_cookie);
        EXPECT_EQ(cookie_kind(scene, a), cookie_kind(again, b));
        if (a.cookie != no_cookie) {
            ++cookies;
            EXPECT_TRUE(scene.images[a.cookie].rgba == again.images[b.cookie].rgba);
        }
        ASSERT_EQ(bool(a.profile), bool(b.profile));
        if (a.profile) {
            ++profiles;
            EXPECT_EQ(a.profile->text, b.profile->text);
        }
    }
    EXPECT_EQ(cookies, 6u);
    EXPECT_EQ(profiles, 5u);
}

TEST(GltfLightDistributions, WrongOnesAreOneLine) {
    const auto error = [](const Json& light, const Json& own) { return strict_error_of(with_light(light, own)); };
    EXPECT_EQ(error(point, cookie(1)), "");
    EXPECT_THAT(error(point, cookie(0)),
                StartsWith("test.glb: light 0: cookie: image 0 of 1x1 pixels is neither 2:1 (equirectangular) nor 6:1 "
                           "(faces of a cube), as a point light's is"));
    EXPECT_THAT(error(point, cookie(3)),
                StartsWith("test.glb: light 0: cookie: image 0 of 3x1 pixels is neither 2:1 (equirectangular) nor 6:1 "
                           "(faces of a cube), as a point light's is"));
    EXPECT_THAT(error(sun, cookie(1)),
                StartsWith("test.glb: light 0: a directional light has no cookie: points and spots do"));
    EXPECT_THAT(error(point, cookie(9)), HasSubstr("light 0 extras prelight cookie texture: index"));
    EXPECT_THAT(error(point, {{"cookie", Json::object()}}),
                StartsWith("test.glb: light 0 extras prelight cookie: has no texture"));
    EXPECT_THAT(error(point, {{"cookie", 3}}), HasSubstr("light 0 extras prelight cookie: is not a JSON object"));
    EXPECT_THAT(
        error({{"type", "spot"}, {"spot", {{"outerConeAngle", 1.5}}}}, cookie(0)),
        StartsWith("test.glb: light 0: cookie: an outer cone of 85.9° is wider than a picture can be thrown (85°)"));
    EXPECT_THAT(error(point, {{"size", 0}}),
                StartsWith("test.glb: light 0 extras prelight: size 0 is not above 0; 0.03 is used"));
    EXPECT_THAT(error(point, {{"size", -1}}), StartsWith("test.glb: light 0 extras prelight: size -1 is not above 0"));
    EXPECT_THAT(error(point, {{"size", "big"}}), HasSubstr("light 0 extras prelight: size"));
    EXPECT_THAT(error(point, {{"ies", Json::object()}}),
                StartsWith("test.glb: light 0 extras prelight ies: has neither uri nor bufferView"));
    EXPECT_THAT(error(point, {{"ies", {{"bufferView", 99}}}}), HasSubstr("light 0 extras prelight ies: bufferView"));
    EXPECT_THAT(error(point, {{"ies", 7}}), HasSubstr("light 0 extras prelight ies: is not a JSON object"));
    EXPECT_THAT(error(point, {{"ies", "../a.ies"}}), HasSubstr("light 0 extras prelight: "));
    EXPECT_THAT(error(point, {{"ies", "http://a/b.ies"}}), HasSubstr("light 0 extras prelight: "));
    EXPECT_THAT(error(point, {{"ies", "data:;base64,SGVsbG8="}}),
                HasSubstr("light 0 extras prelight: ies: line 1: there is no TILT= line"));
    const std::string good = "data:;base64," + base64({ies.begin(), ies.end()});
    EXPECT_THAT(error(sun, {{"ies", good}}),
                StartsWith("test.glb: light 0: a directional light has no profile (ies): points and spots do"));
    EXPECT_THAT(error(point, {{"ies", {{"uri", good}, {"candela", 1}}}}), HasSubstr("candela"));
}

TEST(GltfLightDistributions, WrongOnesLeaveTheLight) {
    for (const Json& own :
         {cookie(3), Json{{"ies", "none.ies"}}, Json{{"ies", "data:;base64,SGVsbG8="}}, Json{{"size", -1}}}) {
        const Scene scene = with_light(point, own).load();
        ASSERT_EQ(scene.lights.size(), 1u) << own;
        EXPECT_EQ(scene.lights[0].cookie, no_cookie) << own;
        EXPECT_FALSE(scene.lights[0].profile) << own;
        EXPECT_GT(scene.lights[0].size, 0) << own;
        EXPECT_EQ(scene.warnings.size(), 1u) << own;
    }
}

TEST(GltfLightDistributions, WritersRefuseWhatReadersDo) {
    const TemporaryFolder folder;
    Scene scene = make_scene("cookies", 3, 1);
    scene.lights[1].cookie = 99;
    EXPECT_THROW(save_glb(scene, folder.path / "a.glb"), Error);
}

// A light's axes are its node's without scale; under animation too.
TEST(LightAxes, AreTheNodesRotation) {
    Scene scene = make_scene("cookies", 2, 1);
    const auto axes_at = [&](double time) { return light_axes(resolve(scene, {}, Moment{time}).lights.at(1)); };
    const auto expect = [](const glm::dmat3& axes, glm::dvec3 right, glm::dvec3 back) {
        EXPECT_LT(glm::distance(axes[0], right), 1e-6);
        EXPECT_LT(glm::distance(axes[1], {0, 1, 0}), 1e-6);
        EXPECT_LT(glm::distance(axes[2], back), 1e-6);
    };
    expect(axes_at(0), {1, 0, 0}, {0, 0, 1});
    expect(axes_at(3), {0, 0, -1}, {1, 0, 0}); // a quarter of the turn
    scene.nodes.at(scene.scenes[0].nodes.back()).trs->scale = {3, -2, 0.5};
    const glm::dmat3 mirrored = light_axes(resolve(scene, {}, Moment{0.0}).lights.at(1));
    EXPECT_NEAR(glm::determinant(mirrored), 1, 1e-12) << "a rotation all the same";
    EXPECT_LT(glm::distance(mirrored[1], {0, -1, 0}), 1e-12);
    // +Y along the way it shines: any that is at a right angle.
    const glm::dmat3 any = light_axes({{}, glm::dvec3(0), {0, -1, 0}});
    EXPECT_NEAR(glm::determinant(any), 1, 1e-12);
    EXPECT_EQ(any[2], glm::dvec3(0, 1, 0));
}

} // namespace
} // namespace prelight
