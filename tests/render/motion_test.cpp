// Animated scenes on the device: posed, bent and morphed as the reference shows them.
#include "against_reference.hpp"
#include <cstdlib>
#include <filesystem>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

class MotionAt : public testing::TestWithParam<double> {};

TEST_P(MotionAt, AgreesWithTheReference) {
    const Scene scene = make_scene("motion", 12, 1);
    const World world = resolve(scene, {}, Moment{GetParam()});
    for (const char* camera : {"front", "flight"})
        expect_agrees({.world = &world, .camera = find_camera(world, camera)});
}

INSTANTIATE_TEST_SUITE_P(Times, MotionAt, testing::Values(0.7, 2.9),
                         [](const auto& time) { return std::to_string(static_cast<int>(10 * time.param)); });

TEST(Motion, ForwardRenderersFindTheLightsOfBentObjects) {
    const Scene scene = make_scene("motion", 12, 1);
    const World world = resolve(scene, {}, Moment{1.1});
    expect_agrees({.world = &world, .camera = find_camera(world, "front"), .renderer = "multipass"});
}

TEST(Motion, RealModelsAgreeWithTheReference) {
    const char* given = std::getenv("PRELIGHT_SHARED_SCENES");
    const std::filesystem::path folder = given ? given : PRELIGHT_SHARED_SCENES;
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no shared scenes beside the repository";
    for (const char* name : {"Fox.glb", "CesiumMan.glb", "MorphStressTest.glb", "RecursiveSkeletons.glb",
                             "gdx-lightCameraAnimations.glb"}) {
        SCOPED_TRACE(name);
        const Scene scene = load_gltf(folder / name);
        EXPECT_FALSE(scene.animations.empty());
        const World world = resolve(scene, {}, Moment{0.4});
        expect_agrees({.world = &world, .camera = world.cameras[0]});
    }
}

} // namespace
} // namespace prelight
