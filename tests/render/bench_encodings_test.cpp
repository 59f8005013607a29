// The figures that `prelight bench encodings` prints.
#include "garden.hpp"
#include <algorithm>
#include <bench/through_target.hpp>
#include <prelight/bench.hpp>

namespace prelight {
namespace {

TEST(BenchEncodings, FiguresAreThoseOfTheTargetAndThePicture) {
    Garden garden;
    garden.add_lights(6, 4, 6);
    std::vector<std::string> told;
    const EncodingBench options{.directions = 10'000, .width = 96, .height = 54, .done = [&](const EncodingFigures& f) {
                                    told.push_back(f.name);
                                }};
    const std::vector<EncodingFigures> all = bench_encodings(test_device(), garden.world, garden.camera, options);
    ASSERT_EQ(all.size(), 7u);
    EXPECT_EQ(told.size(), all.size());
    const std::vector<glm::vec4> directions = bench::directions(10'000);
    for (const EncodingFigures& f : all) {
        SCOPED_TRACE(f.name);
        EXPECT_EQ(f.directions, 10'240u) << "whole rows";
        const auto& info = passes::find_normal_encoding(f.name);
        const auto through = bench::through_normal_target(dynamic_cast<gpu::Context&>(test_device()), info, directions);
        std::vector<double> angles;
        for (size_t i = 0; i < directions.size(); ++i) {
            const glm::dvec3 a = glm::normalize(glm::dvec3(directions[i])),
                             b = glm::normalize(glm::dvec3(through.decoded[i]));
            angles.push_back(glm::degrees(2 * std::asin(glm::length(a - b) / 2)));
        }
        std::sort(angles.begin(), angles.end());
        double sum = 0;
        for (const double angle : angles)
            sum += angle;
        EXPECT_NEAR(f.mean, sum / 10'240, 1e-7);
        EXPECT_NEAR(f.percentile_99, angles[10'239 * 99 / 100], 1e-7);
        EXPECT_NEAR(f.max, angles.back(), 1e-7);

        Shot shot = garden.shot();
        shot.width = 96;
        shot.height = 54;
        shot.settings = {{"normals", f.name}, {"specular-antialiasing", "off"}};
        EXPECT_EQ(f.picture.psnr, against_reference(test_device(), shot).psnr);
    }
    EXPECT_EQ(all[0].target, "RGBA8");
    EXPECT_EQ(all[0].bytes, 4u);
    EXPECT_EQ(all[1].bytes, 6u) << "oct32 needs a target for roughness";
    expect_validation_clean(test_device());
}

TEST(BenchEncodings, DepthsGoThroughTheirTargets) {
    Garden garden;
    garden.add_lights(6, 4, 6);
    const auto all = bench_depth_sources(test_device(), garden.world, garden.camera, {.width = 96, .height = 54});
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].name, "attachment");
    EXPECT_FALSE(all[0].relative);
    EXPECT_EQ(all[0].bytes, 0u);
    EXPECT_EQ(all[1].relative, 0) << "r32f";
    // Eleven bits: half a step of 2⁻¹⁰ rounded, a whole one cut off.
    EXPECT_GT(*all[2].relative, 0.95 / 2048) << "r16f";
    EXPECT_LE(*all[2].relative, 1.0 / 1024) << "r16f";
    EXPECT_EQ(all[3].relative, 0) << "rgba8";
    EXPECT_EQ(all[3].picture.psnr, all[1].picture.psnr);
    EXPECT_LT(all[2].picture.psnr, all[1].picture.psnr);
    expect_validation_clean(test_device());
}

TEST(BenchEncodings, DirectionsAreEvenlySpread) {
    const std::vector<glm::vec4> directions = bench::directions(1 << 16);
    glm::dvec3 mean(0);
    glm::dmat3 square(0);
    for (const glm::vec4& d : directions) {
        const glm::dvec3 n(d);
        EXPECT_NEAR(glm::length(n), 1, 1e-6);
        mean += n / double(directions.size());
        square += glm::outerProduct(n, n) / double(directions.size());
    }
    EXPECT_LT(glm::length(mean), 1e-3);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(square[i][j], i == j ? 1.0 / 3 : 0, 1e-3);
}

} // namespace
} // namespace prelight
