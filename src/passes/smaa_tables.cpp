#include "smaa_tables.hpp"
#include <algorithm>
#include <cmath>

namespace prelight::passes {
namespace {

/// ∫ max(f, 0) over an interval of this width, for f that goes straight from `from` to `to`.
double positive_part(double from, double to, double width) {
    if (from <= 0 && to <= 0)
        return 0;
    if (from >= 0 && to >= 0)
        return width * (from + to) / 2;
    const double most = std::max(from, to);
    return width * most * most / (2 * std::abs(to - from));
}

struct Place {
    double x, y; ///< pixels; y goes up
};

/// Adds what the line from `a` to `b` cuts off the pixels that meet along y = 0 between `x` and `x` + 1.
void add_cut(EdgeAreas& areas, const Place& a, const Place& b, double x) {
    const double low = std::max(a.x, x), high = std::min(b.x, x + 1);
    if (low >= high)
        return;
    const auto y = [&](double at) { return a.y + (b.y - a.y) * (at - a.x) / (b.x - a.x); };
    areas.above += positive_part(y(low), y(high), high - low);
    areas.below += positive_part(-y(low), -y(high), high - low);
}

/// The share of the pixel with this lower left corner that lies under the line through `a` and `b`.
double share_below(const Place& a, const Place& b, const Place& pixel) {
    const auto y = [&](double at) { return a.y + (b.y - a.y) * (at - a.x) / (b.x - a.x) - pixel.y; };
    const double from = y(pixel.x), to = y(pixel.x + 1);
    return positive_part(from, to, 1) - positive_part(from - 1, to - 1, 1);
}

/// Where the line ends at a crossing, from the edge: half a pixel along what crosses.
double height(int crossing) {
    return crossing == SMAA_CROSSING_ABOVE ? 0.5 : crossing == SMAA_CROSSING_BELOW ? -0.5 : 0;
}

uint32_t packed(const EdgeAreas& areas) {
    const auto code = [](double share) { return static_cast<uint32_t>(std::lround(65535 * share)); };
    return code(areas.below) | code(areas.above) << 16;
}

} // namespace

EdgeAreas smaa_area(int before, int after, int left, int right) {
    constexpr int both = SMAA_CROSSING_ABOVE | SMAA_CROSSING_BELOW;
    double start = height(before), end = height(after);
    // Where edges cross on both sides, the one that makes a Z of the line counts.
    if (before == both)
        start = -end;
    else if (after == both)
        end = -start;
    const double length = left + right + 1;
    EdgeAreas areas;
    if (start != 0 && start == -end) {
        add_cut(areas, {0, start}, {length, end}, left); // Z
    } else {                                             // U, or L with one half flat
        add_cut(areas, {0, start}, {length / 2, 0}, left);
        add_cut(areas, {length / 2, 0}, {length, end}, left);
    }
    return areas;
}

EdgeAreas smaa_diagonal_area(int before, int after, int left, int right) {
    // The edge of step i goes from (i + 1, i + 1) to (i + 2, i + 1). The line begins at the far end of what crosses;
    // where both do or nothing does, either may be meant, and the mean of the two is taken.
    const double length = left + right + 1;
    EdgeAreas areas;
    for (const bool level : {true, false}) {
        const auto is_level = [](int crossing, bool unknown) {
            return crossing == SMAA_CROSSING_LEVEL || (crossing != SMAA_CROSSING_UPRIGHT && unknown);
        };
        const Place start{1, is_level(before, level) ? 1.0 : 0.0};
        // The other one than at the start, so that a diagonal with both ends out of sight is at 45°.
        const Place end{length + 1, length + (is_level(after, !level) ? 0.0 : 1.0)};
        const double x = left + 1;
        areas.below += 0.5 * (1 - share_below(start, end, {x, x - 1}));
        areas.above += 0.5 * share_below(start, end, {x, x});
    }
    return areas;
}

std::vector<uint32_t> smaa_areas() {
    std::vector<uint32_t> areas(SMAA_AREAS);
    for (int before = 0; before < SMAA_CROSSINGS; ++before)
        for (int after = 0; after < SMAA_CROSSINGS; ++after) {
            for (int left = 0; left < SMAA_DISTANCES; ++left)
                for (int right = 0; right < SMAA_DISTANCES; ++right)
                    areas[static_cast<size_t>(shared::smaa_area_index(before, after, left, right))] =
                        packed(smaa_area(before, after, left, right));
            for (int left = 0; left < SMAA_DIAGONAL_DISTANCES; ++left)
                for (int right = 0; right < SMAA_DIAGONAL_DISTANCES; ++right)
                    areas[static_cast<size_t>(shared::smaa_diagonal_index(before, after, left, right))] =
                        packed(smaa_diagonal_area(before, after, left, right));
        }
    return areas;
}

} // namespace prelight::passes
