// SMAA's table of areas against closed forms, and against points counted under the lines that the patterns mean.
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <passes/smaa_tables.hpp>

namespace prelight {
namespace {

using passes::EdgeAreas;
using passes::smaa_area;
using passes::smaa_diagonal_area;
constexpr int above = SMAA_CROSSING_ABOVE, below = SMAA_CROSSING_BELOW, both = above | below;
constexpr int upright = SMAA_CROSSING_UPRIGHT, level = SMAA_CROSSING_LEVEL;

void expect_areas(const EdgeAreas& got, double below_share, double above_share) {
    EXPECT_NEAR(got.below, below_share, 1e-12);
    EXPECT_NEAR(got.above, above_share, 1e-12);
}

TEST(SmaaTables, HaveTheAreasOfSimplePatterns) {
    expect_areas(smaa_area(0, 0, 3, 4), 0, 0);
    expect_areas(smaa_area(both, both, 3, 4), 0, 0);
    expect_areas(smaa_area(above, 0, 0, 0), 0, 0.125);    // an L of one pixel: a triangle of half by half
    expect_areas(smaa_area(above, 0, 0, 1), 0, 0.25);     // of two: a triangle of one by half
    expect_areas(smaa_area(above, 0, 1, 0), 0, 0);        // its flat half
    expect_areas(smaa_area(above, above, 0, 0), 0, 0.25); // a U of one pixel
    expect_areas(smaa_area(below, above, 0, 0), 0.125, 0.125);
    expect_areas(smaa_area(below, above, 0, 1), 0.25, 0);           // a Z of two
    expect_areas(smaa_area(both, below, 0, 1), 0, 0.25);            // makes a Z
    expect_areas(smaa_diagonal_area(upright, level, 0, 3), 0.5, 0); // exactly 45° through the pixels' corners
    expect_areas(smaa_diagonal_area(level, upright, 2, 2), 0, 0.5);
    expect_areas(smaa_diagonal_area(0, 0, 4, 4), 0.25, 0.25);
}

// All of a line's areas are those of its triangles.
TEST(SmaaTables, SumUpToTheTriangles) {
    for (int length = 1; length <= SMAA_DISTANCES; ++length) {
        EdgeAreas l, z, u;
        for (int i = 0; i < length; ++i) {
            const auto add = [&](EdgeAreas& sum, int before, int after) {
                const EdgeAreas one = smaa_area(before, after, i, length - 1 - i);
                sum.below += one.below, sum.above += one.above;
            };
            add(l, below, 0), add(z, above, below), add(u, above, above);
        }
        expect_areas(l, length / 8.0, 0);
        expect_areas(z, length / 8.0, length / 8.0);
        expect_areas(u, 0, length / 4.0);
    }
}

TEST(SmaaTables, AreTheSameMirrored) {
    for (int before = 0; before < SMAA_CROSSINGS; ++before)
        for (int after = 0; after < SMAA_CROSSINGS; ++after)
            for (int left = 0; left < SMAA_DISTANCES; ++left)
                for (int right = 0; right < SMAA_DISTANCES; ++right) {
                    const EdgeAreas one = smaa_area(before, after, left, right);
                    expect_areas(smaa_area(after, before, right, left), one.below, one.above);
                    if (left >= SMAA_DIAGONAL_DISTANCES || right >= SMAA_DIAGONAL_DISTANCES)
                        continue;
                    const EdgeAreas diagonal = smaa_diagonal_area(before, after, left, right); // turned round
                    expect_areas(smaa_diagonal_area(after, before, right, left), diagonal.above, diagonal.below);
                }
}

/// How high the revectorised line is at `x`, pixels from the edge; written from the patterns' drawings.
double height_of_line(int before, int after, double length, double x) {
    const auto way = [](int crossing) { return crossing == above ? 1 : crossing == below ? -1 : 0; };
    int from = way(before), to = way(after);
    if (before == both && after != both)
        from = -to;
    if (after == both && before != both)
        to = -from;
    if (from * to < 0)
        return 0.5 * from * (1 - 2 * x / length);
    return x < length / 2 ? 0.5 * from * (1 - 2 * x / length) : 0.5 * to * (2 * x / length - 1);
}

TEST(SmaaTables, AgreeWithPointsCountedUnderTheLines) {
    double worst = 0;
    for (int before = 0; before < SMAA_CROSSINGS; ++before)
        for (int after = 0; after < SMAA_CROSSINGS; ++after)
            for (int left = 0; left < SMAA_DISTANCES; ++left)
                for (int right = 0; right < SMAA_DISTANCES; ++right) {
                    double sum_below = 0, sum_above = 0;
                    constexpr int points = 256;
                    for (int i = 0; i < points; ++i) {
                        const double y = height_of_line(before, after, left + right + 1, left + (i + 0.5) / points);
                        (y < 0 ? sum_below : sum_above) += std::abs(y) / points;
                    }
                    const EdgeAreas got = smaa_area(before, after, left, right);
                    worst = std::max({worst, std::abs(got.below - sum_below), std::abs(got.above - sum_above)});
                }
    EXPECT_LT(worst, 1e-4);
}

/// The share of points of a pixel below the line through a and b.
double counted_below(std::array<double, 2> a, std::array<double, 2> b, int x, int y) {
    constexpr int points = 128;
    int inside = 0;
    for (int i = 0; i < points; ++i)
        for (int j = 0; j < points; ++j) {
            const double px = x + (i + 0.5) / points - a[0], py = y + (j + 0.5) / points - a[1];
            inside += (b[0] - a[0]) * py < (b[1] - a[1]) * px;
        }
    return inside / double(points * points);
}

// A staircase whose step i is the edge from (i, i) to (i + 1, i): the line begins a pixel below its first corner or at
// it, and ends at its last or a pixel above it.
TEST(SmaaTables, AgreeWithPointsCountedUnderDiagonals) {
    double worst = 0;
    for (int before = 0; before < SMAA_CROSSINGS; ++before)
        for (int after = 0; after < SMAA_CROSSINGS; ++after)
            for (int left = 0; left < SMAA_DIAGONAL_DISTANCES; ++left)
                for (int right = 0; right < SMAA_DIAGONAL_DISTANCES; ++right) {
                    const double steps = left + right + 1;
                    std::vector<double> starts, ends;
                    for (const int one : {level, upright}) {
                        if (before == one || before == 0 || before == both)
                            starts.push_back(one == level ? 0 : -1);
                        if (after == one || after == 0 || after == both)
                            ends.push_back(one == level ? steps - 1 : steps);
                    }
                    double sum_below = 0, sum_above = 0;
                    for (int i = 0; i < 2; ++i) { // both open: a line along the corners on either side
                        const double start = starts[starts.size() == 2 ? i : 0],
                                     end = ends[ends.size() == 2 ? 1 - i : 0];
                        sum_below += 0.5 - 0.5 * counted_below({0, start}, {steps, end}, left, left - 1);
                        sum_above += 0.5 * counted_below({0, start}, {steps, end}, left, left);
                    }
                    const EdgeAreas got = smaa_diagonal_area(before, after, left, right);
                    worst = std::max({worst, std::abs(got.below - sum_below), std::abs(got.above - sum_above)});
                }
    EXPECT_LT(worst, 0.01);
}

TEST(SmaaTables, PackEachWhereItIsFound) {
    const std::vector<uint32_t> all = passes::smaa_areas();
    ASSERT_EQ(all.size(), size_t(SMAA_AREAS));
    const auto at = [&](int index) { return all[static_cast<size_t>(index)]; };
    EXPECT_EQ(at(shared::smaa_area_index(above, 0, 0, 1)), 16384u << 16); // 0.25
    EXPECT_EQ(at(shared::smaa_diagonal_index(upright, level, 0, 3)), 32768u);
    EXPECT_EQ(shared::smaa_diagonal_index(both, both, SMAA_DIAGONAL_REACH, SMAA_DIAGONAL_REACH), SMAA_AREAS - 1);
}

} // namespace
} // namespace prelight
