// What the reader makes of animations, skins and morph targets, and what it refuses.
#include "gltf_builder.hpp"
#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

using namespace prelight;
using namespace prelight::test;
using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;
using testing::Pointwise;
using testing::SizeIs;
using testing::StartsWith;

namespace {

const std::vector<float> identities{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                    1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};

/// The triangle with two joints (nodes 1 and 2), one morph target, and an animation of both: channel
/// 0 moves node 2, channel 1 turns node 1, channel 2 blends the target.
GltfBuilder animated() {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.attributes()["JOINTS_0"] = b.add_values<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 5121, "VEC4");
    b.attributes()["WEIGHTS_0"] = b.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0}, "VEC4");
    b.primitive()["targets"] = {{{"POSITION", b.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")}}};
    b.json["nodes"][0]["skin"] = 0;
    b.json["nodes"].push_back({{"children", {2}}});
    b.json["nodes"].push_back({{"translation", {1, 0, 0}}});
    b.json["scenes"][0]["nodes"].push_back(1);
    b.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", b.add_floats(identities, "MAT4")}}};
    const size_t times = b.add_floats({0, 1}, "SCALAR");
    const float s = std::sqrt(0.5f);
    b.json["animations"] = {
        {{"name", "all"},
         {"samplers",
          {{{"input", times}, {"output", b.add_floats({1, 0, 0, 1, 2, 0}, "VEC3")}},
           {{"input", times}, {"output", b.add_floats({0, 0, 0, 1, 0, 0, s, s}, "VEC4")}, {"interpolation", "STEP"}},
           {{"input", times},
            {"output", b.add_floats({0, 0, 0, 0, 1, 0}, "SCALAR")},
            {"interpolation", "CUBICSPLINE"}}}},
         {"channels",
          {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}},
           {{"sampler", 1}, {"target", {{"node", 1}, {"path", "rotation"}}}},
           {{"sampler", 2}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    return b;
}

Json& sampler(GltfBuilder& b, size_t i) { return b.json["animations"][0]["samplers"][i]; }
Json& channel(GltfBuilder& b, size_t i) { return b.json["animations"][0]["channels"][i]; }

TEST(GltfAnimation, ReadsAllOfIt) {
    GltfBuilder b = animated();
    b.json["meshes"][0]["weights"] = {0.25};
    b.json["nodes"][0]["weights"] = {0.75};
    const Scene scene = b.load();
    EXPECT_THAT(scene.warnings, SizeIs(0));
    ASSERT_THAT(scene.animations, SizeIs(1));
    const Animation& animation = scene.animations[0];
    EXPECT_EQ(animation.name, "all");
    ASSERT_THAT(animation.samplers, SizeIs(3));
    EXPECT_THAT(animation.samplers[0].times, ElementsAre(0, 1));
    EXPECT_THAT(animation.samplers[0].values, ElementsAre(1, 0, 0, 1, 2, 0));
    EXPECT_EQ(animation.samplers[0].interpolation, Interpolation::linear);
    EXPECT_EQ(animation.samplers[1].interpolation, Interpolation::step);
    EXPECT_EQ(animation.samplers[2].interpolation, Interpolation::cubic_spline);
    ASSERT_THAT(animation.channels, SizeIs(3));
    EXPECT_EQ(animation.channels[1].node, 1u);
    EXPECT_EQ(animation.channels[1].path, AnimationPath::rotation);
    EXPECT_EQ(animation.channels[2].path, AnimationPath::weights);
    ASSERT_THAT(scene.skins, SizeIs(1));
    EXPECT_THAT(scene.skins[0].joints, ElementsAre(1, 2));
    ASSERT_THAT(scene.skins[0].inverse_bind, SizeIs(2));
    EXPECT_EQ(scene.skins[0].inverse_bind[1][3], glm::dvec4(-1, 0, 0, 1));
    EXPECT_THAT(scene.meshes[0].weights, ElementsAre(0.25f));
    EXPECT_THAT(scene.nodes[0].weights, ElementsAre(0.75f));
    EXPECT_EQ(scene.nodes[0].skin, 0u);
    const Primitive& p = scene.meshes[0].primitives[0];
    ASSERT_THAT(p.joint_sets, SizeIs(1));
    EXPECT_EQ(p.joint_sets[0].joints[2][1], 1);
    EXPECT_EQ(p.joint_sets[0].weights[2], glm::vec4(0.5, 0.5, 0, 0));
    ASSERT_THAT(p.morph_targets, SizeIs(1));
    EXPECT_EQ(p.morph_targets[0].positions[1], glm::vec3(0, 0, 1));
    EXPECT_TRUE(p.morph_targets[0].normals.empty());
    ASSERT_TRUE(scene.nodes[2].trs);
    EXPECT_EQ(scene.nodes[2].trs->translation, glm::dvec3(1, 0, 0));
    // Half way: the target by a half; joint 1 at (1, 1, 0), of which vertex (0, 1, 0) takes a half.
    const World world = resolve(scene, {}, Moment{0.5, 0});
    const Instance& shown = world.instances.at(0);
    const glm::dvec3 top(shown.transform * glm::dvec4(world.mesh_of(shown).primitives[0].positions[2], 1));
    EXPECT_NEAR(top.x, 0, 1e-6);
    EXPECT_NEAR(top.y, 1.5, 1e-6);
    EXPECT_NEAR(top.z, 0.5, 1e-6);
}

TEST(GltfAnimation, NormalisedIntegersAreFractions) {
    GltfBuilder b = animated();
    const auto normalised = [&b](size_t accessor) {
        b.json["accessors"][accessor]["normalized"] = true;
        return accessor;
    };
    sampler(b, 1)["output"] = normalised(b.add_values<int16_t>({0, 0, 0, 32767, 0, 0, -32767, 0}, 5122, "VEC4"));
    sampler(b, 2)["output"] = normalised(b.add_values<uint8_t>({0, 51, 0, 0, 255, 0}, 5121, "SCALAR"));
    b.attributes()["WEIGHTS_0"] =
        normalised(b.add_values<uint16_t>({65535, 0, 0, 0, 65535, 0, 0, 0, 13107, 52428, 0, 0}, 5123, "VEC4"));
    b.attributes()["JOINTS_0"] = b.add_values<uint16_t>({0, 0, 0, 0, 1, 9, 0, 0, 0, 1, 0, 0}, 5123, "VEC4");
    b.primitive()["targets"][0]["POSITION"] =
        normalised(b.add_values<int8_t>({0, 0, 127, 0, 0, 0, -127, 0, 0, 0, 0, 0}, 5120, "VEC4"));
    b.json["accessors"].back()["type"] = "VEC3";
    b.json["bufferViews"].back()["byteStride"] = 4;
    const Scene scene = b.load();
    EXPECT_THAT(scene.animations[0].samplers[1].values, ElementsAre(0, 0, 0, 1, 0, 0, -1, 0));
    EXPECT_THAT(scene.animations[0].samplers[2].values, Pointwise(FloatNear(1e-6f), {0.f, 0.2f, 0.f, 0.f, 1.f, 0.f}));
    const JointSet& set = scene.meshes[0].primitives[0].joint_sets[0];
    EXPECT_NEAR(set.weights[2].x, 0.2, 1e-6);
    EXPECT_EQ(set.joints[1][1], 0) << "a joint of weight 0 may have any number";
    EXPECT_EQ(scene.meshes[0].primitives[0].morph_targets[0].positions[1], glm::vec3(0, 0, -1));
}

TEST(GltfAnimation, SparseTargetsAndSeveralJointSets) {
    GltfBuilder b = animated();
    const size_t indices = b.add_view(bytes_of<uint8_t>({1}));
    const size_t values = b.add_view(bytes_of<float>({0, 3, 0}));
    b.primitive()["targets"] = {
        {{"POSITION", b.add_accessor({{"componentType", 5126},
                                      {"type", "VEC3"},
                                      {"count", 3},
                                      {"sparse",
                                       {{"count", 1},
                                        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                        {"values", {{"bufferView", values}}}}}})},
         {"NORMAL", b.add_floats({1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3")}}};
    b.attributes()["WEIGHTS_0"] = b.add_floats({0.5, 0, 0, 0, 0.5, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    b.attributes()["JOINTS_1"] = b.add_values<uint8_t>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 5121, "VEC4");
    b.attributes()["WEIGHTS_1"] = b.add_floats({0.5, 0, 0, 0, 0.5, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    const Scene scene = b.load();
    const Primitive& p = scene.meshes[0].primitives[0];
    EXPECT_THAT(p.morph_targets[0].positions, ElementsAre(glm::vec3(0), glm::vec3(0, 3, 0), glm::vec3(0)));
    EXPECT_THAT(p.morph_targets[0].normals, SizeIs(3));
    ASSERT_THAT(p.joint_sets, SizeIs(2));
    EXPECT_EQ(p.joint_sets[1].weights[2].x, 1);
    EXPECT_EQ(resolve(scene).triangles, 1u);
}

TEST(GltfAnimation, WithoutNormalsTheyAreFlatInEveryPose) {
    GltfBuilder b = animated();
    b.attributes().erase("NORMAL");
    b.primitive()["targets"][0]["NORMAL"] = b.primitive()["targets"][0]["POSITION"];
    b.primitive()["indices"] = b.add_values<uint8_t>({0, 1, 2, 2, 1, 0}, 5121, "SCALAR");
    const Scene scene = b.load();
    const Primitive& p = scene.meshes[0].primitives[0];
    EXPECT_TRUE(p.flat_normals);
    EXPECT_THAT(p.positions, SizeIs(6));
    EXPECT_THAT(p.joint_sets[0].joints, SizeIs(6));
    EXPECT_THAT(p.morph_targets[0].positions, SizeIs(6));
    EXPECT_THAT(p.morph_targets[0].normals, SizeIs(0));
    const World world = resolve(scene, {}, Moment{1, 0});
    const Primitive& bent = world.mesh_of(world.instances[0]).primitives[0];
    EXPECT_NEAR(bent.normals[0].z, 1, 1e-6);
    EXPECT_NEAR(bent.normals[3].z, -1, 1e-6);
}

TEST(GltfAnimation, WhatMovesNothingIsLeftOutWithAWarning) {
    GltfBuilder b = animated();
    channel(b, 0)["target"].erase("node");
    channel(b, 1)["target"]["path"] = "pointer";
    b.json["nodes"].push_back({{"skin", 0}});
    b.primitive()["targets"][0]["COLOR_0"] = 0;
    const Scene scene = b.load();
    EXPECT_THAT(scene.animations[0].channels, SizeIs(1));
    EXPECT_FALSE(scene.nodes[3].skin);
    EXPECT_THAT(scene.warnings,
                testing::UnorderedElementsAre(HasSubstr("animation 0 channel 0: channels that move no node's"),
                                              HasSubstr("node 3: a skin without a mesh that has joints"),
                                              HasSubstr("mesh 0 primitive 0 target 0: morph targets move no")));
}

class GltfAnimationErrors : public testing::TestWithParam<Damage> {};

TEST_P(GltfAnimationErrors, OneLineThatNamesTheObject) { expect_told(animated(), GetParam()); }

std::vector<Damage> damaged_animations() {
    return {
        {"JointsWithoutWeights", [](GltfBuilder& b) { b.attributes().erase("WEIGHTS_0"); },
         "mesh 0 primitive 0: JOINTS_0 and WEIGHTS_0 must stand together", true},
        {"WeightsWithoutJoints", [](GltfBuilder& b) { b.attributes().erase("JOINTS_0"); },
         "mesh 0 primitive 0: JOINTS_0 and WEIGHTS_0 must stand together", true},
        {"JointsAsFloats", [](GltfBuilder& b) { b.attributes()["JOINTS_0"] = b.attributes()["WEIGHTS_0"]; },
         "mesh 0 primitive 0: JOINTS_0: accessor"},
        {"WeightsAsIntegers", [](GltfBuilder& b) { b.attributes()["WEIGHTS_0"] = b.attributes()["JOINTS_0"]; },
         "mesh 0 primitive 0: WEIGHTS_0: accessor", true},
        {"JointsTooNarrow", [](GltfBuilder& b) { b.attributes()["JOINTS_0"] = b.attributes()["POSITION"]; },
         "mesh 0 primitive 0: JOINTS_0: accessor"},
        {"JointsTooShort",
         [](GltfBuilder& b) {
             b.attributes()["JOINTS_0"] = b.add_values<uint8_t>({0, 0, 0, 0}, 5121, "VEC4");
         },
         "mesh 0 primitive 0: JOINTS_0: has 1 values for 3 vertices"},
        {"NegativeWeight",
         [](GltfBuilder& b) {
             b.attributes()["WEIGHTS_0"] = b.add_floats({1, 0, 0, 0, 2, -1, 0, 0, 1, 0, 0, 0}, "VEC4");
         },
         "mesh 0 primitive 0: WEIGHTS_0: vertex 1 has a negative weight", true},
        {"WeightNotFinite",
         [](GltfBuilder& b) {
             b.attributes()["WEIGHTS_0"] = b.add_floats({1, 0, 0, 0, no_number, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
         },
         "mesh 0 primitive 0: WEIGHTS_0: vertex 1 is not finite", true},
        {"JointBeyondSkin",
         [](GltfBuilder& b) {
             b.attributes()["JOINTS_0"] = b.add_values<uint8_t>({0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0}, 5121, "VEC4");
         },
         "node 0: its mesh follows joint 2, but skin 0 has 2"},
        {"MatrixAsAttribute",
         [](GltfBuilder& b) { b.attributes()["WEIGHTS_0"] = b.json["skins"][0]["inverseBindMatrices"]; },
         "accessor 6: holds matrices"},
        {"SkinIndex", [](GltfBuilder& b) { b.json["nodes"][0]["skin"] = 1; }, "node 0: skin is 1, but there are 1"},
        {"SkinWithoutJoints", [](GltfBuilder& b) { b.json["skins"][0].erase("joints"); }, "skin 0: has no joints"},
        {"SkinJointIndex", [](GltfBuilder& b) { b.json["skins"][0]["joints"][1] = 3; },
         "skin 0: joints holds 3, but there are 3"},
        {"SkeletonIndex", [](GltfBuilder& b) { b.json["skins"][0]["skeleton"] = 3; }, "skin 0: skeleton is 3"},
        {"SkeletonCycle", [](GltfBuilder& b) { b.json["nodes"][2]["children"] = {1}; }, "node 1: is its own ancestor"},
        {"FewInverseBindMatrices",
         [](GltfBuilder& b) {
             b.json["skins"][0]["inverseBindMatrices"] =
                 b.add_floats({identities.begin(), identities.begin() + 16}, "MAT4");
         },
         "skin 0: has 2 joints, but 1 inverse bind matrices"},
        {"InverseBindType", [](GltfBuilder& b) { b.json["skins"][0]["inverseBindMatrices"] = 0; },
         "skin 0: inverseBindMatrices: accessor 0 holds VEC3 of floats, not MAT4 of floats"},
        {"InverseBindNotFinite",
         [](GltfBuilder& b) {
             std::vector<float> m = identities;
             m[20] = no_number;
             b.json["skins"][0]["inverseBindMatrices"] = b.add_floats(m, "MAT4");
         },
         "skin 0: inverse bind matrix 1 is not finite", true},
        {"InverseBindLastRow",
         [](GltfBuilder& b) {
             std::vector<float> m = identities;
             m[15] = 2;
             b.json["skins"][0]["inverseBindMatrices"] = b.add_floats(m, "MAT4");
         },
         "skin 0: inverse bind matrix 0: its last row is not 0 0 0 1", true},
        {"InverseBindBeyondView",
         [](GltfBuilder& b) {
             b.json["accessors"][b.json["skins"][0]["inverseBindMatrices"].get<size_t>()]["count"] = 3;
         },
         "accessor 6: 3 elements of 64 bytes"},
        {"TargetsNoObjects", [](GltfBuilder& b) { b.primitive()["targets"] = {5}; },
         "mesh 0 primitive 0 target 0: is not a JSON object"},
        {"TargetType", [](GltfBuilder& b) { b.primitive()["targets"][0]["POSITION"] = b.attributes()["TEXCOORD_0"]; },
         "mesh 0 primitive 0 target 0: POSITION: accessor 2 holds VEC2 of floats, not VEC3 of floats; it is left out",
         true},
        {"TargetTooShort",
         [](GltfBuilder& b) {
             b.primitive()["targets"][0]["NORMAL"] = b.add_floats({0, 0, 0}, "VEC3");
         },
         "mesh 0 primitive 0 target 0: NORMAL: has 1 values for 3 vertices"},
        {"TargetNotFinite",
         [](GltfBuilder& b) {
             b.primitive()["targets"][0]["POSITION"] = b.add_floats({0, 0, 0, 0, 0, 0, 0, no_number, 0}, "VEC3");
         },
         "mesh 0 primitive 0 target 0: POSITION: vertex 2 is not finite", true},
        {"TargetAccessor", [](GltfBuilder& b) { b.primitive()["targets"][0]["POSITION"] = 99; },
         "mesh 0 primitive 0 target 0: POSITION is 99"},
        {"TargetCountsDiffer",
         [](GltfBuilder& b) {
             Json second = b.primitive();
             second.erase("targets");
             b.json["meshes"][0]["primitives"].push_back(second);
         },
         "mesh 0 primitive 1: has 0 morph targets, but the mesh's first has 1"},
        {"MeshWeights",
         [](GltfBuilder& b) {
             b.json["meshes"][0]["weights"] = {1, 2};
         },
         "mesh 0: weights has 2 values for 1 morph targets", true},
        {"NodeWeights",
         [](GltfBuilder& b) {
             b.json["nodes"][0]["weights"] = {1, 2};
         },
         "node 0: weights has 2 values for 1 morph targets", true},
        {"WeightTooLarge", [](GltfBuilder& b) { b.json["nodes"][0]["weights"] = {1e300}; },
         "node 0: weights 0 is no number that fits into 32 bits", true},
        {"ChannelSampler", [](GltfBuilder& b) { channel(b, 0)["sampler"] = 3; },
         "animation 0 channel 0: sampler is 3, but there are 3"},
        {"ChannelTarget", [](GltfBuilder& b) { channel(b, 0).erase("target"); },
         "animation 0 channel 0: target is missing", true},
        {"ChannelNode", [](GltfBuilder& b) { channel(b, 0)["target"]["node"] = 3; },
         "animation 0 channel 0 target: node is 3, but there are 3"},
        {"ChannelOfMatrix",
         [](GltfBuilder& b) {
             b.json["nodes"][2] = {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
         },
         "animation 0 channel 0: node 2 has a matrix", true},
        {"SamplerWidth", [](GltfBuilder& b) { channel(b, 0)["sampler"] = 1; },
         "animation 0 channel 0: sampler 1: output: accessor", true},
        {"SamplerTooFew",
         [](GltfBuilder& b) {
             sampler(b, 0)["output"] = b.add_floats({0, 0, 0}, "VEC3");
         },
         "animation 0 channel 0: sampler 0: it has 1 values for 2 keyframes", true},
        {"SamplerNoTriples", [](GltfBuilder& b) { sampler(b, 0)["interpolation"] = "CUBICSPLINE"; },
         "animation 0 channel 0: its sampler has 1 values for each keyframe, which needs 3", true},
        {"SamplerWeightsTooMany", [](GltfBuilder& b) { sampler(b, 2)["interpolation"] = "LINEAR"; },
         "animation 0 channel 2: its sampler has 3 values for each keyframe, which needs 1", true},
        {"SamplerInterpolation", [](GltfBuilder& b) { sampler(b, 1)["interpolation"] = "SPHERICAL"; },
         "animation 0 sampler 1: interpolation \"SPHERICAL\"", true},
        {"SamplerInput", [](GltfBuilder& b) { sampler(b, 0).erase("input"); },
         "animation 0 sampler 0: input is missing"},
        {"SamplerInputType", [](GltfBuilder& b) { sampler(b, 0)["input"] = 0; },
         "animation 0 channel 0: sampler 0: input: accessor 0 holds VEC3 of floats, not SCALAR of floats", true},
        {"SamplerOutputType",
         [](GltfBuilder& b) {
             sampler(b, 0)["output"] = b.add_values<uint8_t>({0, 0, 0, 0, 0, 0}, 5121, "VEC3");
         },
         "animation 0 channel 0: sampler 0: output: accessor", true},
        {"TimeNegative",
         [](GltfBuilder& b) {
             sampler(b, 0)["input"] = b.add_floats({-1, 1}, "SCALAR");
         },
         "animation 0 sampler 0: keyframe 0 (at -1 s) is before 0 s; it counts", true},
        {"TimeNotFinite",
         [](GltfBuilder& b) {
             sampler(b, 0)["input"] = b.add_floats({0, no_number}, "SCALAR");
         },
         "animation 0 sampler 0: keyframe 1 (at nan s) is not finite; it is left out", true},
        {"TimeTwice",
         [](GltfBuilder& b) {
             sampler(b, 0)["input"] = b.add_floats({1, 1}, "SCALAR");
         },
         "animation 0 sampler 0: keyframe 1 (at 1 s) is at the time of another", true},
        {"ValueNotFinite",
         [](GltfBuilder& b) {
             sampler(b, 0)["output"] = b.add_floats({0, 0, 0, 0, no_number, 0}, "VEC3");
         },
         "animation 0 sampler 0: keyframe 1 (at ", true},
    };
}

INSTANTIATE_TEST_SUITE_P(Kinds, GltfAnimationErrors, testing::ValuesIn(damaged_animations()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(GltfAnimation, EveryDamagedByteEndsInASceneOrOneLine) {
    const Bytes good = animated().glb();
    size_t errors = 0;
    for (size_t i = 20; i < good.size(); ++i)
        for (const uint8_t flip : {0xff, 0x01, 0x10}) {
            Bytes bytes = good;
            bytes[i] ^= flip;
            const std::string line = error_of(bytes);
            ASSERT_EQ(line.find('\n'), std::string::npos);
            errors += !line.empty() || !load_bytes(bytes).warnings.empty();
        }
    EXPECT_GT(errors, good.size()) << "most of the file is JSON, and each byte of it counts";
}

TEST(GltfAnimation, MemoryIsBounded) {
    GltfBuilder targets = animated(); // 100,000 nodes with 2,000 morph targets each: weights alone
    targets.json["meshes"][0]["primitives"][0]["targets"] = Json(2'000, targets.primitive()["targets"][0]);
    targets.json["animations"] = Json::array();
    for (int i = 0; i < 100'000; ++i)
        targets.json["nodes"].push_back({{"mesh", 0}});
    EXPECT_THAT(error_of(targets), HasSubstr("needs more memory than a file of this size may take"));
    GltfBuilder keys = animated(); // one long accessor, read by many samplers
    const size_t times = keys.add_accessor({{"componentType", 5126}, {"type", "SCALAR"}, {"count", 1}});
    const size_t values = keys.add_accessor({{"componentType", 5126}, {"type", "VEC3"}, {"count", 100'000'000}});
    sampler(keys, 0) = {{"input", times}, {"output", values}};
    EXPECT_THAT(error_of(keys), StartsWith("test.glb: animation 0 sampler 0: needs more memory"));
}

} // namespace
