// The figures that `prelight bench light-buffers` prints.
#include "against_reference.hpp"
#include <bench/light_wall.hpp>
#include <fmt/format.h>
#include <prelight/bench_light_buffers.hpp>

namespace prelight {
namespace {

TEST(BenchLightBuffers, FiguresAreThoseOfTheBuffers) {
    std::vector<size_t> told;
    const std::vector<LightBufferFigures> all = bench_light_buffers(
        test_device(),
        {.overlaps = {1, 16}, .width = 48, .height = 27, .done = [&](const std::vector<LightBufferFigures>& row) {
             told.push_back(row.size());
         }});
    EXPECT_EQ(told, std::vector<size_t>(28, 2)); // 15 buffers blended and once, LUV once only
    ASSERT_EQ(all.size(), 56u);
    const auto find = [&](const std::string& name, const std::string& writes, uint32_t overlap) {
        for (const LightBufferFigures& f : all)
            if (f.name == name && f.writes == writes && f.overlap == overlap)
                return f;
        ADD_FAILURE() << name << " " << writes << " " << overlap;
        return LightBufferFigures{};
    };
    for (const LightBufferFigures& f : all) {
        SCOPED_TRACE(f.name + " " + f.writes + fmt::format(" {}", f.overlap));
        EXPECT_GT(f.diffuse.rms, 0);
        EXPECT_GE(f.diffuse.max, f.diffuse.rms);
        EXPECT_LE(std::abs(f.diffuse.bias), f.diffuse.rms);
        EXPECT_LT(f.diffuse.rms, 0.1) << "R11G11B10F loses 6 % by blending 16 lights where floats are cut off";
        EXPECT_GE(f.specular.max, f.specular.rms);
        if (f.specular_way == "stored") {
            EXPECT_EQ(f.specular.rms, f.rounding.rms) << "exact but for rounding";
        } else if (f.overlap == 16 && f.light_buffer == "packed-rgba16f") {
            EXPECT_GT(f.specular.rms, 3 * f.rounding.rms) << "an approximation";
        }
    }
    // Half a step of a half float is 1/4096 of the value at most where it is rounded, a whole one where cut off.
    EXPECT_LT(find("RGBA16F pair", "once", 16).diffuse.rms, 1.0 / 2048);
    EXPECT_LT(find("RGBA16F packed", "once", 1).rounding.rms, 1.0 / 1024);
    // One light: ways 2, 3 and 4 are what they approximate.
    for (const char* name : {"LUV, RGBA16F", "fifth channel, RGBA16F", "luminance, RGBA16F"})
        EXPECT_LT(find(name, "once", 1).specular.rms, 0.02) << name;
    // Sixteen blended roundings, and one.
    for (const char* name : {"RGBA8 pair", "R11G11B10F pair", "RGB10A2 pair"})
        EXPECT_GT(find(name, "blended", 16).diffuse.rms, 1.5 * find(name, "once", 16).diffuse.rms) << name;
    // Two bits of headroom.
    EXPECT_GT(find("RGBA8 pair, 4 x headroom", "once", 1).diffuse.rms, 3 * find("RGBA8 pair", "once", 1).diffuse.rms);
    expect_validation_clean(test_device());
}

TEST(BenchLightBuffers, EveryPixelOfTheWallHasEveryLight) {
    const bench::LightWall wall(7, 48, 27);
    RenderOptions options{.width = 48, .height = 27, .count_pairs = true};
    const auto renderer = create_renderer("light-prepass", &test_device(), options);
    renderer->set_world(wall.world());
    renderer->render(wall.camera());
    EXPECT_EQ(renderer->stats().pairs_contributing, 7u * 48 * 27);
    float most = 0;
    for (const glm::vec3& p : wall.diffuse().pixels)
        most = std::max({most, p.x, p.y, p.z});
    EXPECT_NEAR(most, bench::LightWall::peak, 1e-5);
}

} // namespace
} // namespace prelight
