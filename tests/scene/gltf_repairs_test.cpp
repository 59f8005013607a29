// What is wrong with one light, camera, node or material costs that alone: values that glTF does not allow, and
// what becomes of them.
#include "gltf_builder.hpp"
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <scene/warnings.hpp>

namespace prelight {
namespace {

using namespace prelight::test;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr float endless = std::numeric_limits<float>::infinity();
constexpr double half_pi = std::numbers::pi / 2;

GltfBuilder beside_good_light(const Json& light) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({light, {{"type", "directional"}, {"name", "good"}}});
    b.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    b.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    b.json["scenes"][0]["nodes"] = {0, 1, 2};
    return b;
}

Light repaired(const Json& light, const std::string& warning) {
    return expect_repaired(beside_good_light(light), warning).lights.at(0);
}

TEST(GltfRepairs, ConesOfSpots) {
    struct Cone {
        Json spot;
        const char* warning;
        float inner, outer;
    };
    const float quarter = float(half_pi / 2), widest = float(half_pi);
    const auto below = [](float outer) { return std::nextafter(outer, 0.f); };
    for (const Cone& c : std::initializer_list<Cone>{
             {{{"innerConeAngle", 0.4}, {"outerConeAngle", 0.4}},
              "innerConeAngle 0.4 is not below outerConeAngle 0.4; the cone has a hard edge",
              below(0.4f),
              0.4f},
             {{{"innerConeAngle", 0.6}, {"outerConeAngle", 0.4}},
              "innerConeAngle 0.6 is not below outerConeAngle 0.4",
              below(0.4f),
              0.4f},
             {{{"innerConeAngle", 1}}, "innerConeAngle 1 is not below outerConeAngle 0.78", below(quarter), quarter},
             {{{"innerConeAngle", -0.1}, {"outerConeAngle", 0.4}},
              "innerConeAngle -0.1 is below 0; 0 is used",
              0,
              0.4f},
             {{{"outerConeAngle", 2}}, "outerConeAngle 2 is beyond π/2; π/2 is used", 0, widest},
             {{{"innerConeAngle", 30}, {"outerConeAngle", 45}},
              "outerConeAngle 45 is beyond π/2",
              below(widest),
              widest},
             {{{"outerConeAngle", 0}}, "outerConeAngle 0 is not above 0; π/4 is used", 0, quarter},
             {{{"outerConeAngle", -1}}, "outerConeAngle -1 is not above 0", 0, quarter},
             {{{"outerConeAngle", "wide"}}, "outerConeAngle is \"wide\", not a number; it is ignored", 0, quarter}}) {
        const Light light = repaired({{"type", "spot"}, {"intensity", 40}, {"spot", c.spot}},
                                     std::string("light 0 spot: ") + c.warning);
        EXPECT_EQ(light.inner_cone, c.inner) << c.spot;
        EXPECT_EQ(light.outer_cone, c.outer) << c.spot;
        EXPECT_LT(light.inner_cone, light.outer_cone) << c.spot;
    }
    // Equal after rounding only, or a rounded π/2: right as they are.
    for (const Json& cone :
         {Json{{"innerConeAngle", 0.4}, {"outerConeAngle", 0.4000000001}}, Json{{"outerConeAngle", half_pi + 1e-6}}}) {
        const Scene scene = beside_good_light({{"type", "spot"}, {"spot", cone}}).load();
        EXPECT_THAT(scene.warnings, ElementsAre()) << cone;
        EXPECT_LT(scene.lights[0].inner_cone, scene.lights[0].outer_cone);
    }
}

TEST(GltfRepairs, RangesColoursAndIntensities) {
    EXPECT_EQ(
        repaired({{"type", "point"}, {"range", 0}}, "light 0: range 0 is not above 0; the light reaches without limit")
            .range,
        endless);
    EXPECT_EQ(repaired({{"type", "spot"}, {"spot", Json::object()}, {"range", 0.0}}, "light 0: range 0 is not").range,
              endless);
    EXPECT_EQ(repaired({{"type", "point"}, {"range", -3}}, "light 0: range -3 is not above 0").range, endless);
    EXPECT_EQ(repaired({{"type", "point"}, {"range", 1e300}}, "light 0: range is 1e+300, not a number that fits").range,
              endless);
    EXPECT_EQ(repaired({{"type", "point"}, {"range", nullptr}}, "light 0: range is null, not a number").range, endless);
    EXPECT_EQ(repaired({{"type", "point"}, {"color", {-1, 0.5, 1}}}, "light 0: color holds -1").colour,
              glm::vec3(0, 0.5f, 1));
    EXPECT_EQ(repaired({{"type", "point"}, {"color", {0.25, 0.5, 1, 1}}},
                       "light 0: color has 4 numbers instead of 3; the first 3 count")
                  .colour,
              glm::vec3(0.25f, 0.5f, 1));
    EXPECT_EQ(
        repaired({{"type", "point"}, {"color", "red"}}, "light 0: color is \"red\", not an array of 3 numbers").colour,
        glm::vec3(1));
    EXPECT_EQ(repaired({{"type", "point"}, {"intensity", "bright"}}, "light 0: intensity is \"bright\"").intensity, 1);
    EXPECT_EQ(repaired({{"type", "point"}, {"name", 5}}, "light 0: name is 5, not a string").name, "");
}

TEST(GltfRepairs, LightsOfUnknownKindsAreLeftOut) {
    for (const char* type : {"ambient", "area", "sun", "Point", ""}) {
        const Scene scene =
            expect_repaired(beside_good_light({{"type", type}, {"intensity", 9}}),
                            fmt::format("light 0: type \"{}\" is not known; the light is left out", type));
        ASSERT_EQ(scene.lights.size(), 1u);
        EXPECT_EQ(scene.lights[0].name, "good");
        EXPECT_FALSE(scene.nodes[1].light);
        EXPECT_EQ(scene.nodes[2].light, 0u);
        EXPECT_EQ(resolve(scene).lights.size(), 1u);
    }
    EXPECT_EQ(expect_repaired(beside_good_light(Json::object()), "light 0: type \"\" is not known").lights.size(), 1u);
    EXPECT_EQ(expect_repaired(beside_good_light({{"type", "point"}, {"intensity", -4}}),
                              "light 0: intensity -4 is negative; the light is left out")
                  .lights.size(),
              1u);
    GltfBuilder bad_index = beside_good_light({{"type", "ambient"}});
    bad_index.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 2;
    EXPECT_EQ(error_of(bad_index), "test.glb: node 1 KHR_lights_punctual: light is 2, but there are 2");
}

TEST(GltfRepairs, CamerasThatShowNothingAreLeftOut) {
    const auto cameras = [](const Json& bad, const std::string& warning) {
        GltfBuilder b = GltfBuilder::triangle();
        b.json["cameras"] = Json::array(
            {bad, {{"type", "perspective"}, {"name", "good"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}});
        b.json["nodes"].push_back({{"camera", 0}});
        b.json["nodes"].push_back({{"camera", 1}});
        b.json["scenes"][0]["nodes"] = {0, 1, 2};
        const Scene scene = expect_repaired(b, warning);
        EXPECT_EQ(resolve(scene).cameras.back().camera.name, "good");
        return scene.cameras;
    };
    const auto perspective = [](const Json& values) { return Json{{"type", "perspective"}, {"perspective", values}}; };
    const auto orthographic = [](const Json& values) {
        return Json{{"type", "orthographic"}, {"orthographic", values}};
    };
    EXPECT_EQ(cameras(perspective({{"yfov", 0}, {"znear", 1}}),
                      "camera 0 perspective: yfov 0 is not 0 … π; the camera is left out")
                  .size(),
              1u);
    EXPECT_EQ(cameras(perspective({{"yfov", 45}, {"znear", 1}}), "camera 0 perspective: yfov 45").size(), 1u);
    EXPECT_EQ(cameras(perspective({{"yfov", 1}, {"znear", 0}}), "camera 0 perspective: znear 0 is not above 0").size(),
              1u);
    EXPECT_EQ(cameras(perspective({{"yfov", 1}}), "camera 0 perspective: znear -1 is not above 0").size(), 1u);
    EXPECT_EQ(
        cameras(orthographic({{"ymag", 0}, {"znear", 0}, {"zfar", 1}}), "camera 0 orthographic: ymag is 0").size(), 1u);
    EXPECT_EQ(cameras(orthographic({{"ymag", 1}, {"znear", 0}}), "camera 0 orthographic: ymag is 0 or zfar is missing")
                  .size(),
              1u);
    EXPECT_EQ(cameras({{"type", "fisheye"}}, "camera 0: type \"fisheye\" is not known").size(), 1u);
    EXPECT_EQ(cameras({{"type", "perspective"}}, "camera 0: type \"perspective\" is not known or has no values").size(),
              1u);
    const auto near = cameras(perspective({{"yfov", 1}, {"znear", 5}, {"zfar", 5}}),
                              "camera 0 perspective: zfar 5 is not beyond znear 5; the camera sees without end");
    ASSERT_EQ(near.size(), 2u);
    EXPECT_EQ(near[0].zfar, std::numeric_limits<double>::infinity());
}

TEST(GltfRepairs, PlacesOfNodes) {
    const auto node = [](const Json& properties, const std::string& warning) {
        GltfBuilder b = GltfBuilder::triangle();
        b.json["nodes"][0].update(properties);
        return expect_repaired(b, warning).nodes.at(0);
    };
    const glm::dmat4 turned = node({{"rotation", {0, 0, 2, 2}}},
                                   "node 0: rotation is no unit quaternion: its length is 2.828; it is made one")
                                  .local;
    EXPECT_NEAR(turned[0].y, 1, 1e-12);
    EXPECT_NEAR(turned[0].x, 0, 1e-12);
    EXPECT_EQ(
        node({{"rotation", {0, 0, 0, 0}}}, "node 0: rotation is no unit quaternion: its length is 0; it turns nothing")
            .local,
        glm::dmat4(1));
    EXPECT_EQ(node({{"rotation", {0, 0, 1}}}, "node 0: rotation has 3 numbers instead of 4").trs->rotation.w, 1);
    EXPECT_EQ(node({{"scale", 2}}, "node 0: scale is 2, not an array of 3 numbers").trs->scale, glm::dvec3(1));
    EXPECT_EQ(node({{"translation", {1, nullptr, 3}}}, "node 0: translation is another array").trs->translation,
              glm::dvec3(0));
    const Node sheared = node({{"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 2}}},
                              "node 0: matrix: its last row is not 0 0 0 1; it is taken for that");
    EXPECT_EQ(sheared.local[3], glm::dvec4(5, 0, 0, 1));
    EXPECT_EQ(sheared.local[0].w, 0);
    EXPECT_EQ(node({{"matrix", {2, 0, 0, 0, 0, 2}}}, "node 0: matrix is another array").local, glm::dmat4(1));
    EXPECT_EQ(node({{"name", {1}}}, "node 0: name is another array, not a string").name, "");
    GltfBuilder rounded = GltfBuilder::triangle();
    rounded.json["nodes"][0]["rotation"] = {0, 0, 0.7071, 0.7071};
    EXPECT_TRUE(rounded.load().warnings.empty()) << "as exporters round";
}

TEST(GltfRepairs, FactorsOfMaterials) {
    const auto material = [](const Json& properties, const std::string& warning) {
        GltfBuilder b = GltfBuilder::textured_triangle();
        b.add_image(png(1, 1, solid(1, 1, {9, 9, 9, 255})));
        b.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}});
        b.json["samplers"] = Json::array({{{"wrapS", 1}, {"wrapT", 33071}, {"magFilter", 5}, {"minFilter", 9728}}});
        b.json["materials"][0] = properties;
        if (warning.find("sampler") == std::string::npos)
            b.json["samplers"] = Json::array({Json::object()});
        return expect_repaired(b, warning).materials.at(0);
    };
    const auto pbr = [&](const Json& values, const std::string& warning) {
        return material({{"pbrMetallicRoughness", values}}, "material 0 pbrMetallicRoughness: " + warning);
    };
    EXPECT_EQ(pbr({{"baseColorFactor", {2, -1, 0.5, 1}}}, "baseColorFactor is 2, outside 0 … 1; 1 is used").base_colour,
              glm::vec4(1, 0, 0.5f, 1));
    EXPECT_EQ(pbr({{"baseColorFactor", {0.5, 0.25, 0}}}, "baseColorFactor has 3 numbers instead of 4").base_colour,
              glm::vec4(0.5f, 0.25f, 0, 1));
    EXPECT_EQ(pbr({{"baseColorFactor", "#ff0000"}}, "baseColorFactor is \"#ff0000\"").base_colour, glm::vec4(1));
    EXPECT_EQ(pbr({{"metallicFactor", 2}}, "metallicFactor is 2, outside 0 … 1").metallic, 1);
    EXPECT_EQ(pbr({{"roughnessFactor", -0.5}}, "roughnessFactor is -0.5, outside 0 … 1; 0 is used").roughness, 0);
    EXPECT_EQ(
        material({{"alphaMode", "GLOW"}}, "material 0: alphaMode \"GLOW\" is not known; OPAQUE is used").alpha_mode,
        AlphaMode::opaque);
    EXPECT_EQ(material({{"alphaMode", "mask"}}, "material 0: alphaMode \"mask\" is not known").alpha_mode,
              AlphaMode::opaque);
    EXPECT_EQ(material({{"alphaMode", "MASK"}, {"alphaCutoff", -1}}, "material 0: alphaCutoff is -1").alpha_cutoff, 0);
    EXPECT_EQ(material({{"emissiveFactor", {-1, 0.5, 0}}}, "material 0: emissiveFactor is -1").emissive,
              glm::vec3(0, 0.5f, 0));
    EXPECT_EQ(material({{"emissiveFactor", {1, 1, 1}},
                        {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", -2}}}}}},
                       "material 0 KHR_materials_emissive_strength: emissiveStrength is -2")
                  .emissive,
              glm::vec3(0));
    EXPECT_FALSE(
        material({{"doubleSided", "yes"}}, "material 0: doubleSided is \"yes\", not true or false").double_sided);
    EXPECT_EQ(material({{"occlusionTexture", {{"index", 0}, {"strength", 3}}}},
                       "material 0 occlusionTexture: strength is 3, outside 0 … 1")
                  .occlusion_strength,
              1);
    const Material sampled =
        material({{"emissiveTexture", {{"index", 0}}}}, "sampler 0: wrapS 1 is not known; REPEAT is used");
    EXPECT_EQ(sampled.emissive_texture.sampler.wrap_s, Wrap::repeat);
    EXPECT_EQ(sampled.emissive_texture.sampler.wrap_t, Wrap::clamp_to_edge);
    EXPECT_EQ(sampled.emissive_texture.sampler.mag, Filter::linear);
    EXPECT_EQ(sampled.emissive_texture.sampler.min, Filter::nearest);
}

TEST(GltfRepairs, EqualWarningsAreOneLineAndKindsOfManyReasonsAFew) {
    Warnings warnings("a.glb");
    for (int i = 0; i < 500; ++i)
        warnings.add("zero", fmt::format("mesh {}", i), "is zero", 2);
    for (int i = 0; i < 100; ++i)
        warnings.add("range", fmt::format("light {}", i), fmt::format("range {}", -i));
    const std::vector<std::string> lines = warnings.lines();
    ASSERT_EQ(lines.size(), 9u);
    EXPECT_EQ(lines[0], "a.glb: mesh 0: is zero (1000 in all)");
    EXPECT_EQ(lines[1], "a.glb: light 0: range 0");
    EXPECT_EQ(lines[8], "a.glb: light 7: range -7 (and 92 more like it)");
    Warnings strict("a\nb.glb", true);
    try {
        strict.add("kind", "light 3", "is dark");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "a\\nb.glb: light 3: is dark");
    }
}

TEST(GltfRepairs, ScenesAreChosenByNameOrIndex) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["nodes"].push_back({{"name", "nothing"}});
    b.json["scenes"] =
        Json::array({{{"name", "full"}, {"nodes", {0}}}, {{"name", "empty"}, {"nodes", {1}}}, {{"nodes", {0, 1}}}});
    const Scene scene = b.load();
    EXPECT_EQ(find_scene(scene, "empty"), 1u);
    EXPECT_EQ(find_scene(scene, "2"), 2u);
    EXPECT_EQ(resolve(scene, find_scene(scene, "full")).triangles, 1u);
    EXPECT_EQ(resolve(scene, find_scene(scene, "empty")).triangles, 0u);
    try {
        find_scene(scene, "3");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "--scene 3: no such scene; there is 0 \"full\", 1 \"empty\", 2 \"\"");
    }
}

TEST(GltfVisibility, HidesANodeAndAllBelowIt) {
    GltfBuilder b = beside_good_light({{"type", "point"}});
    b.json["cameras"] = Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}});
    b.json["extensionsUsed"] = {"KHR_node_visibility"};
    b.json["extensionsRequired"] = {"KHR_node_visibility"};
    const auto hide = [](const Json& visible) { return Json{{"KHR_node_visibility", {{"visible", visible}}}}; };
    // 3 holds 4, which holds the mesh again, and a light and a camera.
    b.json["nodes"].push_back({{"children", {4, 5}}, {"extensions", hide(true)}});
    b.json["nodes"].push_back({{"mesh", 0}, {"children", {6}}});
    b.json["nodes"].push_back({{"camera", 0}});
    b.json["nodes"].push_back(
        {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}, {"KHR_node_visibility", {{"visible", true}}}}}});
    b.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const auto seen = [](const Scene& scene) {
        const World world = resolve(scene);
        EXPECT_EQ(world.cameras.size(), 1u) << "a camera sees, hidden or not";
        return std::pair(world.triangles, world.lights.size());
    };
    EXPECT_EQ(seen(b.load()), (std::pair<uint64_t, size_t>(2, 3)));
    b.json["nodes"][3]["extensions"] = hide(false);
    const Scene hidden = b.load();
    EXPECT_TRUE(hidden.warnings.empty());
    EXPECT_EQ(seen(hidden), (std::pair<uint64_t, size_t>(1, 2))) << "whatever nodes below say of themselves";
    const TemporaryFolder folder;
    save_glb(hidden, folder.path / "a.glb");
    EXPECT_EQ(seen(load_gltf(folder.path / "a.glb")), (std::pair<uint64_t, size_t>(1, 2)));
    b.json["nodes"][3]["extensions"] = hide("no");
    EXPECT_EQ(seen(expect_repaired(b, "node 3 KHR_node_visibility: visible is \"no\", not true or false")),
              (std::pair<uint64_t, size_t>(2, 3)));
}

TEST(Escaped, ControlCharactersAndBytesThatAreNoText) {
    EXPECT_EQ(escaped("plain ü … 漢 😀 a\\nb"), "plain ü … 漢 😀 a\\nb");
    EXPECT_EQ(escaped("a\nb\tc\rd\x1b[31m\x7f"), "a\\nb\\tc\\rd\\x1b[31m\\x7f");
    EXPECT_EQ(escaped(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(escaped("\xc2\x9b\xe2\x80\xae\xe2\x81\xa6"), "\\x9b\\u202e\\u2066") << "C1, and what turns text around";
    EXPECT_EQ(escaped("\xff\xc3(\xed\xa0\x80\xc0\xaf\xe2\x82"), "\\xff\\xc3(\\xed\\xa0\\x80\\xc0\\xaf\\xe2\\x82")
        << "no UTF-8";
    EXPECT_EQ(escaped(escaped("\n\x1b")), escaped("\n\x1b"));
    EXPECT_STREQ(UsageError("a\nb").what(), "a\\nb");
}

} // namespace
} // namespace prelight
