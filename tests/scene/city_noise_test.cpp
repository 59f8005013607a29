#include <cmath>
#include <gtest/gtest.h>
#include <scene/procedural/city_noise.hpp>
#include <scene/procedural/random.hpp>

namespace prelight::city {
namespace {

TEST(CityNoise, RowsHaveTheNumbersOfPoints) {
    struct Case {
        uint32_t period, octaves, width;
    };
    for (const auto& [period, octaves, width] : {Case{5, 4, 64}, Case{230, 1, 128}, Case{7, 3, 100}, Case{1, 2, 16}}) {
        const TileNoise noise(period, 31, octaves);
        const NoiseRows rows(noise, width);
        std::vector<float> row(width);
        for (const float v : {0.0f, 0.5f / 128, 0.3f, 0.77f, 127.5f / 128}) {
            rows.row(v, row);
            for (uint32_t x = 0; x < width; ++x)
                ASSERT_EQ(row[x], noise({(static_cast<float>(x) + 0.5f) / static_cast<float>(width), v}))
                    << period << ", " << x << ", " << v;
        }
    }
}

TEST(CityNoise, PaintsWithNoisesAndIndicesOfTexels) {
    const TileNoise a(3, 1), b(4, 2, 2);
    const auto grey = [](float v) { return glm::vec4(v, v, v, v); };
    const TextureImage alone = paint(
        "", 32, 16, [&](glm::vec2 uv) { return grey(a(uv) * b(uv)); }, false);
    const TextureImage rows = paint(
        "", 32, 16, [&](glm::vec2, float p, float q) { return grey(p * q); }, false, a, b);
    EXPECT_EQ(alone.rgba, rows.rgba);
    const Field products = sample_field(
        16, [](glm::vec2, float p, float q) { return p * q; }, a, b);
    const TextureImage square = paint(
        "", 16, 16, [&](glm::vec2 uv) { return grey(a(uv) * b(uv)); }, false);
    EXPECT_EQ(square.rgba, paint(
                               "", 16, 16, [&](glm::vec2, size_t i) { return grey(products[i]); }, false)
                               .rgba);
}

/// All points of the plane near the square, one by one.
TEST(CityNoise, CellsFindTheNearestPoints) {
    constexpr uint32_t period = 5, seed = 9;
    const TileCells cells(period, seed);
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const glm::vec2 uv(random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5));
        std::vector<std::pair<float, uint32_t>> all;
        for (int y = -4; y < 9; ++y)
            for (int x = -4; x < 9; ++x) {
                const auto column = static_cast<uint32_t>(x + 5) % period, row = static_cast<uint32_t>(y + 5) % period;
                const glm::vec2 point(static_cast<float>(x) + hash_unit(column, row, seed),
                                      static_cast<float>(y) + hash_unit(column, row, seed + 1));
                const glm::vec2 off = point - uv * static_cast<float>(period);
                if (std::max(std::abs(std::floor(uv.x * period) - static_cast<float>(x)),
                             std::abs(std::floor(uv.y * period) - static_cast<float>(y))) <= 1)
                    all.emplace_back(std::hypot(off.x, off.y), row * period + column);
            }
        std::sort(all.begin(), all.end());
        const Cellular found = cells(uv);
        EXPECT_NEAR(found.nearest, all[0].first, 1e-5);
        EXPECT_NEAR(found.second, all[1].first, 1e-5);
        EXPECT_EQ(found.cell, all[0].second);
    }
}

} // namespace
} // namespace prelight::city
