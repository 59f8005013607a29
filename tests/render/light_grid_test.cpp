// A grid over the world lists each pixel's lights.
#include "garden.hpp"
#include <cstring>
#include <passes/light_grid.hpp>
#include <random>

namespace prelight {
namespace {

Shot grid_shot(const Garden& garden) {
    Shot shot = garden.shot();
    shot.renderer = "z-prepass";
    shot.settings = {{"lights", "grid"}};
    return shot;
}

TEST(LightGrid, AgreesWithTheReferenceWithPointsSpotsAndLightsWithoutRange) {
    Garden garden;
    garden.add_lights(24, 2.5f, 4);
    garden.add_light(garden.spot(0.6f, 8, 60), {1, 4, 2}, {0, -1, -0.2});
    garden.add_light(garden.point(9, 20), garden.camera.position - garden.camera.axes[2]); // the camera is in it
    garden.add_light({.kind = LightKind::directional, .intensity = 0.4f}, {0, 0, 0}, {-0.3, -1, -0.5});
    Shot shot = grid_shot(garden);
    expect_agrees(shot);
    shot.camera.camera.kind = ProjectionKind::orthographic;
    shot.camera.camera.ymag = 3;
    shot.camera.camera.znear = 0.1;
    shot.camera.camera.zfar = 40;
    expect_agrees(shot);
}

TEST(LightGrid, AgreesFarFromTheOrigin) {
    Garden garden({10000, 50, -10000});
    garden.add_lights(24, 2.5f, 4);
    expect_agrees(grid_shot(garden));
}

TEST(LightGrid, HoldsEveryContributingLightOfRandomScenes) {
    std::mt19937 random(11);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int scene = 0; scene < 4; ++scene) {
        Garden garden;
        for (int i = 0; i < 60; ++i) {
            const float range = static_cast<float>(std::exp(uniform(-2.5, 1.5)));
            const Light light =
                i % 2 ? garden.spot(static_cast<float>(uniform(0.02, 1.57)), range, 4) : garden.point(range, 4);
            const glm::dvec3 axis(uniform(-1, 1), uniform(-1, 0.2), uniform(-1, 1));
            garden.add_light(light, garden.at(uniform(-6, 6), uniform(-0.2, 4), uniform(-6, 9)), axis);
        }
        Shot shot = grid_shot(garden);
        shot.width = 160;
        shot.height = 90;
        const Rendered grid = render_counting_pairs(shot, 2);
        EXPECT_LT(grid.stats.draws, 20u); // depth and shading, each object once
        shot.settings = {{"lights", "per-draw"}};
        const Rendered baseline = render_counting_pairs(shot, 2);
        EXPECT_EQ(grid.stats.pairs_contributing, baseline.stats.pairs_contributing) << "scene " << scene;
        EXPECT_LT(grid.stats.pairs_evaluated, baseline.stats.pairs_evaluated) << "scene " << scene;
        EXPECT_GE(compare_pixels(grid.linear, baseline.linear).psnr, 60) << "scene " << scene;
    }
    expect_validation_clean(test_device());
}

TEST(LightGrid, GivesTheSameBytesTwice) {
    Garden garden;
    garden.add_lights(300, 2, 3);
    const Image once = render_counting_pairs(grid_shot(garden), 1).linear;
    const Image twice = render_counting_pairs(grid_shot(garden), 3).linear;
    EXPECT_EQ(std::memcmp(once.pixels.data(), twice.pixels.data(), once.pixels.size() * sizeof(once.pixels[0])), 0);
}

TEST(LightGrid, AgreesOnSwiftShader) {
    Device* const device = swiftshader_device();
    if (!device)
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium)";
    Garden garden;
    garden.add_lights(40, 2.5f, 4);
    Shot shot = grid_shot(garden);
    shot.width = 160;
    shot.height = 90;
    const Comparison c = against_reference(*device, shot);
    EXPECT_GE(c.psnr, half_float_bound.psnr);
    EXPECT_LE(c.block, half_float_bound.block);
    expect_validation_clean(*device);
}

TEST(LightGrid, CellsCoverTheWorldAndStayWithinTheirNumber) {
    for (const glm::dvec3& size :
         {glm::dvec3(100, 5, 100), glm::dvec3(0, 0, 0), glm::dvec3(1e5, 1e-3, 1), glm::dvec3(3, 3, 3)}) {
        resident::Draw draw;
        draw.low = {10, 20, -30};
        draw.high = draw.low + size;
        const passes::LightGrid grid = passes::light_grid(resident::box_around(std::span(&draw, 1)));
        EXPECT_LE(uint64_t(grid.cells.x) * grid.cells.y * grid.cells.z, 32768u);
        const glm::dvec3 end = grid.low + grid.cell * glm::dvec3(grid.cells);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LT(grid.low[axis], draw.low[axis]);
            EXPECT_GT(end[axis], draw.high[axis]);
        }
    }
}

} // namespace
} // namespace prelight
