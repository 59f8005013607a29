// The yardstick scene with few and many lights, and the built-in scenes, against the reference.
#include "against_reference.hpp"
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

Shot shot_of(const World& world) { return {.world = &world, .camera = world.cameras.at(0)}; }

class LightCounts : public testing::TestWithParam<uint32_t> {};

TEST_P(LightCounts, AgreeWithTheReference) {
    const Scene scene = make_scene("lights", GetParam(), 1);
    const World world = resolve(scene);
    expect_agrees(shot_of(world));
}
INSTANTIATE_TEST_SUITE_P(Lights, LightCounts, testing::Values(1, 16, 256, 4096));

TEST(BuiltinScenes, CityAgreesWithTheReference) {
    const Scene scene = make_scene("city", 256, 1);
    const World world = resolve(scene);
    expect_agrees(shot_of(world));
}

TEST(BuiltinScenes, SpheresAgreeWithTheReference) {
    const Scene scene = make_scene("spheres", 8, 1);
    const World world = resolve(scene);
    expect_agrees(shot_of(world));
}

TEST(LightCount, SixtyFiveThousandLightsAreAllDrawn) {
    const Scene scene = make_scene("lights", 65536, 1);
    const World world = resolve(scene);
    Shot shot = shot_of(world);
    shot.width = 96;
    shot.height = 54;
    shot.exposure = -6;
    expect_agrees(shot);
}

} // namespace
} // namespace prelight
