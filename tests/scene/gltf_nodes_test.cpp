#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

using namespace prelight;
using namespace prelight::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

TEST(GltfNodes, TranslationRotationScaleCompose) {
    GltfBuilder b = GltfBuilder::triangle();
    const double half = std::sqrt(0.5);
    b.json["nodes"][0].update({{"translation", {10, 20, 30}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 3, -4}}});
    const glm::dmat4 m = b.load().nodes[0].local;
    const glm::dvec4 p = m * glm::dvec4(1, 1, 1, 1); // a quarter turn about z: x → y, y → −x
    EXPECT_NEAR(p.x, 10 - 3, 1e-12);
    EXPECT_NEAR(p.y, 20 + 2, 1e-12);
    EXPECT_NEAR(p.z, 30 - 4, 1e-12);
}

TEST(GltfNodes, MatricesAreColumnByColumnInDouble) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["nodes"][0]["matrix"] = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 10, 0, 10000000.001, 12, 13, 1};
    const glm::dmat4 m = b.load().nodes[0].local;
    EXPECT_EQ(m[1], glm::dvec4(4, 5, 6, 0));
    EXPECT_EQ(m[3], glm::dvec4(10000000.001, 12, 13, 1));
}

TEST(GltfNodes, SeveralScenesAndTheDefaultOne) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["nodes"].push_back({{"mesh", 0}, {"name", "second"}});
    b.json["scenes"].push_back({{"name", "other"}, {"nodes", {1}}});
    b.json["scene"] = 1;
    const Scene scene = b.load();
    ASSERT_THAT(scene.scenes, SizeIs(2));
    EXPECT_EQ(scene.scenes[1].name, "other");
    EXPECT_EQ(resolve(scene).instances.at(0).node, 1u);
    EXPECT_EQ(resolve(scene, 0).instances.at(0).node, 0u);
    b.json.erase("scenes");
    b.json.erase("scene");
    EXPECT_THAT(b.load().scenes.at(0).nodes, ElementsAre(0, 1)); // every root
}

TEST(GltfNodes, CamerasOfEveryKind) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["cameras"] = Json::array(
        {{{"type", "perspective"}, {"name", "far"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"zfar", 50}}}},
         {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.01}}}},
         {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}}}}});
    const Scene scene = b.load();
    ASSERT_THAT(scene.cameras, SizeIs(3));
    EXPECT_EQ(scene.cameras[0].name, "far");
    EXPECT_EQ(scene.cameras[0].yfov, 0.7);
    EXPECT_EQ(scene.cameras[0].zfar, 50);
    EXPECT_EQ(scene.cameras[1].zfar, std::numeric_limits<double>::infinity());
    EXPECT_EQ(scene.cameras[2].kind, ProjectionKind::orthographic);
    EXPECT_EQ(scene.cameras[2].ymag, 2);
    EXPECT_EQ(scene.cameras[2].znear, 0);
}

TEST(GltfNodes, LightsOfEveryKind) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["extensionsRequired"] = {"KHR_lights_punctual"};
    b.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "directional"}, {"intensity", 5}},
                     {{"type", "point"}, {"color", {1, 0.5, 0}}, {"range", 7}, {"name", "lamp"}},
                     {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}},
                     {{"type", "spot"}, {"spot", Json::object()}}});
    b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 2;
    const Scene scene = b.load();
    ASSERT_THAT(scene.lights, SizeIs(4));
    EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
    EXPECT_EQ(scene.lights[0].intensity, 5);
    EXPECT_EQ(scene.lights[1].colour, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(scene.lights[1].range, 7);
    EXPECT_EQ(scene.lights[1].name, "lamp");
    EXPECT_EQ(scene.lights[1].falloff, Falloff::gltf);
    EXPECT_EQ(scene.lights[2].kind, LightKind::spot);
    EXPECT_EQ(scene.lights[2].inner_cone, 0.2f);
    EXPECT_EQ(scene.lights[2].outer_cone, 0.4f);
    EXPECT_EQ(scene.lights[2].range, std::numeric_limits<float>::infinity());
    EXPECT_EQ(scene.lights[3].outer_cone, float(std::numbers::pi / 4));
    EXPECT_EQ(scene.nodes[0].light, 2u);
}

TEST(GltfNodes, InstancingFromEveryAttribute) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const size_t t = b.add_floats({1, 2, 3, 4, 5, 6}, "VEC3");
    const size_t r = b.add_values<int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}, 5122, "VEC4");
    b.json["accessors"][r]["normalized"] = true;
    const size_t s = b.add_floats({1, 1, 1, 2, 2, 2}, "VEC3");
    b.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", t}, {"ROTATION", r}, {"SCALE", s}};
    b.json["nodes"][0]["translation"] = {100, 0, 0};
    const Scene scene = b.load();
    const World world = resolve(scene);
    ASSERT_THAT(world.instances, SizeIs(2));
    EXPECT_EQ(world.triangles, 2u);
    EXPECT_EQ(world.instances[0].transform[3], glm::dvec4(101, 2, 3, 1));
    const glm::dvec4 corner = world.instances[1].transform * glm::dvec4(1, 0, 0, 1); // half a turn
    EXPECT_NEAR(corner.x, 100 + 4 - 2, 1e-6);
    EXPECT_NEAR(corner.y, 5, 1e-6);
}

TEST(GltfNodes, UnknownExtensionsInUseGiveOneWarning) {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["extensionsUsed"] = {"VENDOR_a", "KHR_lights_punctual", "VENDOR_b"};
    EXPECT_THAT(b.load().warnings, ElementsAre("test.glb: VENDOR_a, VENDOR_b: not supported, left out"));
}

} // namespace
