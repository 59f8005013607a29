// Keyframes against values by hand, and what they make of a world.
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prelight/error.hpp>
#include <prelight/scene.hpp>
#include <scene/animate.hpp>

using namespace prelight;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;
using testing::SizeIs;

namespace {

testing::Matcher<std::vector<double>> near(const std::vector<double>& values, double tolerance = 1e-7) {
    return Pointwise(testing::DoubleNear(tolerance), values);
}

TEST(Sample, StepHoldsTheEarlierKeyframe) {
    const AnimationSampler sampler{{1, 2, 4}, {10, 20, 30}, Interpolation::step};
    EXPECT_THAT(sample(sampler, 0, 1, false), ElementsAre(10));
    EXPECT_THAT(sample(sampler, 1.999, 1, false), ElementsAre(10));
    EXPECT_THAT(sample(sampler, 2, 1, false), ElementsAre(20));
    EXPECT_THAT(sample(sampler, 3.9, 1, false), ElementsAre(20));
    EXPECT_THAT(sample(sampler, 4, 1, false), ElementsAre(30));
}

TEST(Sample, LinearGoesStraightAndStopsAtItsEnds) {
    const AnimationSampler sampler{{1, 2, 4}, {10, 0, 20, -8, 30, 4}, Interpolation::linear};
    EXPECT_THAT(sample(sampler, -5, 2, false), ElementsAre(10, 0));
    EXPECT_THAT(sample(sampler, 1.25, 2, false), ElementsAre(12.5, -2));
    EXPECT_THAT(sample(sampler, 3, 2, false), ElementsAre(25, -2));
    EXPECT_THAT(sample(sampler, 100, 2, false), ElementsAre(30, 4));
}

TEST(Sample, CubicSplineTakesTangentsPerSecond) {
    // In-tangent, value, out-tangent; two seconds apart.
    const AnimationSampler sampler{{1, 3}, {9, 1, 0.5f, -2, 4, 9}, Interpolation::cubic_spline};
    EXPECT_THAT(sample(sampler, 0, 1, false), ElementsAre(1));
    EXPECT_THAT(sample(sampler, 3.5, 1, false), ElementsAre(4));
    // t = 1/2: (1 + 4)/2 + 2 · (1/8) · (0.5 − (−2)).
    EXPECT_THAT(sample(sampler, 2, 1, false), near({3.125}));
    // t = 1/4: 27/32 · 1 + 2 · 9/64 · 0.5 + 5/32 · 4 + 2 · (−3/64) · (−2).
    EXPECT_THAT(sample(sampler, 1.5, 1, false), near({0.84375 + 0.140625 + 0.625 + 0.1875}));
}

TEST(Sample, RotationsTakeTheShorterArc) {
    const float s = std::sqrt(0.5f);
    // 0° and 90° about z, the second with its sign turned: still 30° after a third of the way.
    const AnimationSampler sampler{{0, 3}, {0, 0, 0, 1, 0, 0, -s, -s}, Interpolation::linear};
    EXPECT_THAT(sample(sampler, 1, 4, true),
                near({0, 0, std::sin(std::acos(-1.0) / 12), std::cos(std::acos(-1.0) / 12)}));
    // The same rotation twice, once with its sign turned: no division by zero.
    const AnimationSampler same{{0, 1}, {0, 0, s, s, 0, 0, -s, -s}, Interpolation::linear};
    EXPECT_THAT(sample(same, 0.5, 4, true), near({0, 0, std::sqrt(0.5), std::sqrt(0.5)}));
}

TEST(Sample, RotationsComeOutOfUnitLength) {
    const AnimationSampler cubic{{0, 2},
                                 {0, 0, 0, 0, 0, 0,    0, 1,    0.5f, 0, 0, 0, //
                                  0, 0, 0, 0, 0, 0.6f, 0, 0.8f, 0,    0, 0, 0},
                                 Interpolation::cubic_spline};
    // t = 1/2: (0, 0.3, 0, 0.9) + 2 · 1/8 · (0.5, 0, 0, 0), then of unit length.
    const double length = std::sqrt(0.125 * 0.125 + 0.09 + 0.81);
    EXPECT_THAT(sample(cubic, 1, 4, true), near({0.125 / length, 0.3 / length, 0, 0.9 / length}));
    const AnimationSampler rounded{{0}, {0, 0, 3, 4}, Interpolation::step};
    EXPECT_THAT(sample(rounded, 1, 4, true), near({0, 0, 0.6, 0.8}));
}

/// A triangle at a node that moves 1 m/s along x, below a parent.
Scene moving_triangle() {
    Scene scene;
    scene.name = "moving";
    Primitive p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    p.normals.assign(3, {0, 0, 1});
    p.indices = {0, 1, 2};
    scene.materials.emplace_back();
    scene.meshes.push_back({"triangle", {p}});
    scene.nodes.resize(2);
    scene.nodes[0].children = {1};
    scene.nodes[0].local = glm::translate(glm::dmat4(1), {0, 10'000, 0});
    scene.nodes[1].mesh = 0;
    scene.nodes[1].trs = Trs{{5, 6, 7}, {1, 0, 0, 0}, {2, 2, 2}};
    scene.nodes[1].local = scene.nodes[1].trs->matrix();
    scene.scenes.push_back({"", {0}});
    scene.animations.push_back(
        {"walk", {{{1, 3}, {0, 0, 0, 2, 0, 0}, Interpolation::linear}}, {{0, 1, AnimationPath::translation}}});
    return scene;
}

TEST(Resolve, WithoutAMomentNothingMoves) {
    const Scene scene = moving_triangle();
    const World world = resolve(scene);
    EXPECT_EQ(world.instances.at(0).transform[3], glm::dvec4(5, 10'006, 7, 1));
    EXPECT_FALSE(world.instances[0].previous_transform);
    EXPECT_FALSE(world.instances[0].deformed);
    EXPECT_FALSE(world.cameras.at(0).previous);
}

TEST(Resolve, AMomentPlacesNodesAndSaysWhereTheyWere) {
    const Scene scene = moving_triangle();
    const World world = resolve(scene, {}, Moment{2, 0.25});
    const Instance& instance = world.instances.at(0);
    // Animation replaces the translation and leaves the scale; the parent stays.
    EXPECT_EQ(instance.transform[3], glm::dvec4(1, 10'000, 0, 1));
    EXPECT_EQ(instance.transform[0], glm::dvec4(2, 0, 0, 0));
    ASSERT_TRUE(instance.previous_transform);
    EXPECT_EQ((*instance.previous_transform)[3], glm::dvec4(0.75, 10'000, 0, 1));
    EXPECT_EQ(world.bounds_min, glm::dvec3(1, 10'000, 0));
    for (const Moment still : {Moment{0.5, 0.25}, Moment{7, 0.25}, Moment{2, 0}})
        EXPECT_FALSE(resolve(scene, {}, still).instances[0].previous_transform) << still.time;
    EXPECT_TRUE(resolve(scene, {}, Moment{1.01, 0.25}).instances[0].previous_transform);
}

TEST(Resolve, CamerasAndLightsMove) {
    Scene scene = moving_triangle();
    scene.nodes[1].camera = 0;
    scene.nodes[1].light = 0;
    scene.cameras.emplace_back();
    scene.lights.emplace_back();
    scene.nodes[1].children = {2};
    scene.nodes.emplace_back().camera = 0; // stands still
    scene.nodes[1].children.clear();
    scene.scenes[0].nodes.push_back(2);
    const World world = resolve(scene, {}, Moment{2, 0.25});
    EXPECT_EQ(world.lights.at(0).position, glm::dvec3(1, 10'000, 0));
    ASSERT_THAT(world.cameras, SizeIs(2));
    EXPECT_EQ(world.cameras[0].position, glm::dvec3(1, 10'000, 0));
    ASSERT_TRUE(world.cameras[0].previous);
    EXPECT_EQ(world.cameras[0].previous->position, glm::dvec3(0.75, 10'000, 0));
    EXPECT_EQ(world.cameras[0].previous->axes, world.cameras[0].axes);
    EXPECT_FALSE(world.cameras[1].previous);
}

TEST(Resolve, TheFirstAnimationOfAPropertyWinsUnlessOneIsChosen) {
    Scene scene = moving_triangle();
    scene.animations.push_back({"turn and jump",
                                {{{0}, {0, 0, 1, 0}, Interpolation::step}, {{0}, {0, 3, 0}, Interpolation::step}},
                                {{0, 1, AnimationPath::rotation}, {1, 1, AnimationPath::translation}}});
    const glm::dmat4 all = resolve(scene, {}, Moment{2}).instances[0].transform;
    EXPECT_EQ(all[3], glm::dvec4(1, 10'000, 0, 1));
    EXPECT_EQ(all[0].x, -2); // half a turn about z
    const glm::dmat4 second = resolve(scene, {}, Moment{2}, 1).instances[0].transform;
    EXPECT_EQ(second[3], glm::dvec4(0, 10'003, 0, 1));
    const glm::dmat4 first = resolve(scene, {}, Moment{2}, 0).instances[0].transform;
    EXPECT_EQ(first[0].x, 2);
    EXPECT_EQ(find_animation(scene, "turn and jump"), 1u);
    EXPECT_EQ(find_animation(scene, "0"), 0u);
    try {
        find_animation(scene, "2");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("0 \"walk\", 1 \"turn and jump\""));
    }
    EXPECT_THROW(resolve(scene, {}, Moment{2}, 2), Error);
}

TEST(Resolve, AnimationsThatDoNotFitEndInALine) {
    const auto line = [](auto damage) -> std::string {
        Scene scene = moving_triangle();
        damage(scene);
        try {
            resolve(scene, {}, Moment{2});
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(line([](Scene&) {}), "");
    EXPECT_THAT(line([](Scene& s) { s.nodes[1].trs.reset(); }), HasSubstr("moving: animation 0: channel 0: node 1"));
    EXPECT_THAT(line([](Scene& s) { s.animations[0].channels[0].node = 2; }), HasSubstr("is not there"));
    EXPECT_THAT(line([](Scene& s) { s.animations[0].channels[0].sampler = 1; }), HasSubstr("is not there"));
    EXPECT_THAT(line([](Scene& s) { s.animations[0].samplers[0].values.pop_back(); }),
                HasSubstr("its sampler has 5 values for 2 keyframes of 3"));
    EXPECT_THAT(line([](Scene& s) { s.animations[0].samplers[0] = {}; }), HasSubstr("0 values for 0 keyframes"));
    EXPECT_THAT(line([](Scene& s) { s.animations[0].samplers[0].values[3] = INFINITY; }),
                HasSubstr("node 1: its world transform is not finite"));
    Scene scene = moving_triangle();
    EXPECT_THROW(resolve(scene, {}, Moment{std::nan("")}), Error);
}

} // namespace
