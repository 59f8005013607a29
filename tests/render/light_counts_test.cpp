// The baseline scene with few and many lights, and the built-in scenes, against the reference.
#include "against_reference.hpp"
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

Shot shot_of(const World& world) { return {.world = &world, .camera = world.cameras.at(0)}; }

class LightCounts : public testing::TestWithParam<uint32_t> {};

TEST_P(LightCounts, AgreeWithTheReference) {
    const Scene scene = make_scene("lights", GetParam(), 1);
    const World world = resolve(scene);
    Shot shot = shot_of(world);
    shot.width = 960; // smaller, and too many pixels lie beside an edge to count
    shot.height = 540;
    expect_agrees(shot);
}
INSTANTIATE_TEST_SUITE_P(Lights, LightCounts, testing::Values(1, 16, 256, 4096));

TEST(BuiltinScenes, SpheresAgreeWithTheReference) {
    const Scene scene = make_scene("spheres", 8, 1);
    const World world = resolve(scene);
    Shot shot = shot_of(world);
    shot.width = 640;
    shot.height = 360;
    expect_agrees(shot);
}

TEST(BuiltinScenes, CityAgreesOverItsWetStreet) {
    // Straight ahead a third of the pixels lie beside leaves and railings; the street fills this view.
    const Scene scene = make_scene("city", 1024, 1);
    const World world = resolve(scene);
    Shot shot = shot_of(world);
    const glm::dvec3 eye = shot.camera.position, ahead = -shot.camera.axes[2];
    shot.camera.camera.yfov = 0.5;
    shot.camera = look_at(shot.camera.camera, eye, eye + glm::dvec3(ahead.x, -0.48, ahead.z));
    shot.width = 640;
    shot.height = 360;
    expect_agrees(shot);
}

TEST(LightCount, SixtyFiveThousandOfShorterRangeAreAllDrawn) {
    // As many lights as the built-in scenes go to, with the overlap of 1,024 of full range.
    const Scene scene = make_scene("lights", 65536, 1);
    World world = resolve(scene);
    for (PlacedLight& light : world.lights)
        light.light.range *= 0.25f;
    Shot shot = shot_of(world);
    shot.width = 960;
    shot.height = 540;
    expect_agrees(shot);
}

} // namespace
} // namespace prelight
