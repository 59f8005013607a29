// Compiled with -O3 (src/CMakeLists.txt): loops over plain numbers, without branches, so that the compiler takes
// several vertices or triangles at once. Branches would be guessed wrong for every other triangle, which costs more
// than all the arithmetic.
#include "screen_triangles.hpp"
#include "wide.hpp"
#include <cmath>

namespace prelight::resident {
namespace {

constexpr int most_centres = 6; ///< that a triangle's box may hold for them to be tried one by one

float least(float a, float b) { return a < b ? a : b; }
float most(float a, float b) { return a > b ? a : b; }
int at_or_above(float v) {
    const int i = static_cast<int>(v);
    return i + (v > static_cast<float>(i) ? 1 : 0);
}
int at_or_below(float v) {
    const int i = static_cast<int>(v);
    return i - (v < static_cast<float>(i) ? 1 : 0);
}

/// Corners of triangles, and what all and what any of a triangle's three are outside of.
struct Corners {
    float ax[most_triangles], ay[most_triangles], bx[most_triangles], by[most_triangles], cx[most_triangles],
        cy[most_triangles];
    uint32_t all_outside[most_triangles], any_outside[most_triangles];
};

/// The pixels whose centres lie in the box around a triangle, or some sample of theirs.
struct Centres {
    int x0[most_triangles], x1[most_triangles], y0[most_triangles], y1[most_triangles];
};

enum State : int { dropped, kept, unsure };

PRELIGHT_WIDE
void classify(const TriangleTest& test, Corners& in, uint32_t count, Centres& centres, int* state) {
    const float margin = test.margin, around = test.margin + test.reach, facing = test.facing;
    for (uint32_t t = 0; t < count; ++t) {
        const float ax = in.ax[t], ay = in.ay[t], bx = in.bx[t], by = in.by[t], cx = in.cx[t], cy = in.cy[t];
        const float low_x = least(least(ax, bx), cx), high_x = most(most(ax, bx), cx);
        const float low_y = least(least(ay, by), cy), high_y = most(most(ay, by), cy);
        // Twice the signed area, positive when clockwise on a screen whose y points down.
        const float turn = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
        const float slack = 2 * margin * (high_x - low_x + high_y - low_y + margin);
        const int x0 = at_or_above(low_x - around - 0.5f), x1 = at_or_below(high_x + around - 0.5f);
        const int y0 = at_or_above(low_y - around - 0.5f), y1 = at_or_below(high_y + around - 0.5f);
        centres.x0[t] = x0;
        centres.x1[t] = x1;
        centres.y0[t] = y0;
        centres.y1[t] = y1;
        const int away = facing * turn < -slack ? 1 : 0;
        const int none = (x0 > x1 ? 1 : 0) | (y0 > y1 ? 1 : 0);
        // The width first: the product of two that are large is no number.
        const int few = (x1 - x0 < most_centres ? 1 : 0) & (y1 - y0 < most_centres ? 1 : 0);
        const int fewer = (x1 - x0 + 1) * (few ? y1 - y0 + 1 : most_centres + 1) <= most_centres ? 1 : 0;
        const int off = (in.all_outside[t] & ~static_cast<uint32_t>(unknown_place)) != 0 ? 1 : 0;
        const int known = (in.any_outside[t] & unknown_place) == 0 ? 1 : 0;
        const int shows = fewer ? unsure : kept;
        const int placed = (away | none) ? dropped : shows;
        state[t] = off ? dropped : (known ? placed : kept);
    }
}

/// 1 where a sample of some pixel lies in the triangle, or so near to it that the device may see it there.
PRELIGHT_WIDE
void try_centres(const TriangleTest& test, Corners& in, Centres& centres, uint32_t count, int* hit) {
    struct Edges {
        float a[most_triangles], b[most_triangles], c[most_triangles];
    } edges[3];
    const float* const xs[] = {in.ax, in.bx, in.cx, in.ax};
    const float* const ys[] = {in.ay, in.by, in.cy, in.ay};
    float sign[most_triangles];
    for (uint32_t t = 0; t < count; ++t) {
        const float turn =
            (in.bx[t] - in.ax[t]) * (in.cy[t] - in.ay[t]) - (in.cx[t] - in.ax[t]) * (in.by[t] - in.ay[t]);
        sign[t] = turn < 0 ? -1.0f : 1.0f;
    }
    for (int e = 0; e < 3; ++e) {
        const float *from_x = xs[e], *from_y = ys[e], *to_x = xs[e + 1], *to_y = ys[e + 1];
        Edges& edge = edges[e];
        for (uint32_t t = 0; t < count; ++t) {
            const float a = -sign[t] * (to_y[t] - from_y[t]), b = sign[t] * (to_x[t] - from_x[t]);
            const float size = std::fabs(a) + std::fabs(b);
            // Both ends may be off by the margin, and so may the sum's rounding be; a sample by its reach.
            const float room = 2 * test.margin * (size + test.margin + 2 * test.reach) + test.reach * size;
            edge.a[t] = a;
            edge.b[t] = b;
            edge.c[t] = room - (a * from_x[t] + b * from_y[t]);
        }
    }
    int x[most_triangles], y[most_triangles], last = 0;
    for (uint32_t t = 0; t < count; ++t) {
        x[t] = centres.x0[t];
        y[t] = centres.y0[t];
        const int tries = (centres.x1[t] - x[t] + 1) * (centres.y1[t] - y[t] + 1);
        last = last > tries ? last : tries;
        hit[t] = 0;
    }
    for (int i = 0; i < last; ++i)
        for (uint32_t t = 0; t < count; ++t) {
            const float px = static_cast<float>(x[t]) + 0.5f, py = static_cast<float>(y[t]) + 0.5f;
            const float e0 = edges[0].a[t] * px + edges[0].b[t] * py + edges[0].c[t];
            const float e1 = edges[1].a[t] * px + edges[1].b[t] * py + edges[1].c[t];
            const float e2 = edges[2].a[t] * px + edges[2].b[t] * py + edges[2].c[t];
            hit[t] |= (least(least(e0, e1), e2) >= 0 ? 1 : 0) & (y[t] <= centres.y1[t] ? 1 : 0);
            const int ends = x[t] == centres.x1[t] ? 1 : 0;
            x[t] = ends ? centres.x0[t] : x[t] + 1;
            y[t] += ends;
        }
}

} // namespace

PRELIGHT_WIDE
void place_vertices(const ScreenPlacing& placing, const glm::vec3* positions, size_t count, const ScreenVertices& out) {
    const glm::mat4& m = placing.clip;
    const float m00 = m[0][0], m10 = m[1][0], m20 = m[2][0], m30 = m[3][0];
    const float m01 = m[0][1], m11 = m[1][1], m21 = m[2][1], m31 = m[3][1];
    const float m02 = m[0][2], m12 = m[1][2], m22 = m[2][2], m32 = m[3][2];
    const float m03 = m[0][3], m13 = m[1][3], m23 = m[2][3], m33 = m[3][3];
    const float beyond_x = placing.beyond.x, beyond_y = placing.beyond.y;
    const float slack_x = placing.slack.x, slack_y = placing.slack.y, slack_z = placing.error.z + placing.error.w;
    const float half_x = placing.half_size.x, half_y = placing.half_size.y;
    const float least_w = most(placing.least_exact_w, 1e-6f);
    float* __restrict xs = out.x;
    float* __restrict ys = out.y;
    uint32_t* __restrict bits = out.outside;
    for (size_t v = 0; v < count; ++v) {
        const float px = positions[v].x, py = positions[v].y, pz = positions[v].z;
        const float x = m00 * px + m10 * py + m20 * pz + m30, y = m01 * px + m11 * py + m21 * pz + m31;
        const float z = m02 * px + m12 * py + m22 * pz + m32, w = m03 * px + m13 * py + m23 * pz + m33;
        const float rounding = 1e-4f * (std::fabs(z) + std::fabs(w)) + slack_z;
        uint32_t outside = x < -w * beyond_x - slack_x ? outside_left : 0u;
        outside |= x > w * beyond_x + slack_x ? outside_right : 0u;
        outside |= y < -w * beyond_y - slack_y ? outside_top : 0u;
        outside |= y > w * beyond_y + slack_y ? outside_bottom : 0u;
        outside |= z > w + rounding ? outside_near : 0u;
        outside |= z < -rounding ? outside_far : 0u;
        const float place_x = half_x + half_x * x / w, place_y = half_y + half_y * y / w;
        const int known =
            (w > least_w ? 1 : 0) & (std::fabs(place_x) < farthest ? 1 : 0) & (std::fabs(place_y) < farthest ? 1 : 0);
        xs[v] = known ? place_x : 0.0f;
        ys[v] = known ? place_y : 0.0f;
        bits[v] = known ? outside : outside | unknown_place;
    }
}

size_t select_triangles(const TriangleTest& test, const uint32_t* indices, uint32_t triangles,
                        const ScreenVertices& vertices, uint32_t* out) {
    Corners corners;
    Centres centres;
    int state[most_triangles];
    for (uint32_t t = 0; t < triangles; ++t) {
        const uint32_t a = indices[3 * t], b = indices[3 * t + 1], c = indices[3 * t + 2];
        corners.ax[t] = vertices.x[a];
        corners.ay[t] = vertices.y[a];
        corners.bx[t] = vertices.x[b];
        corners.by[t] = vertices.y[b];
        corners.cx[t] = vertices.x[c];
        corners.cy[t] = vertices.y[c];
    }
    for (uint32_t t = 0; t < triangles; ++t) {
        const auto outside = [&](uint32_t corner) {
            return vertices.outside ? vertices.outside[indices[3 * t + corner]] : 0u;
        };
        corners.all_outside[t] = outside(0) & outside(1) & outside(2);
        corners.any_outside[t] = outside(0) | outside(1) | outside(2);
    }
    classify(test, corners, triangles, centres, state);
    // Those that are not sure stand side by side for what takes longer.
    uint32_t which[most_triangles + 1], unsure_ones = 0;
    for (uint32_t t = 0; t < triangles; ++t) {
        which[unsure_ones] = t;
        unsure_ones += state[t] == unsure ? 1 : 0;
    }
    for (uint32_t i = 0; i < unsure_ones; ++i) { // which[i] ≥ i
        const uint32_t t = which[i];
        corners.ax[i] = corners.ax[t];
        corners.ay[i] = corners.ay[t];
        corners.bx[i] = corners.bx[t];
        corners.by[i] = corners.by[t];
        corners.cx[i] = corners.cx[t];
        corners.cy[i] = corners.cy[t];
        centres.x0[i] = centres.x0[t];
        centres.x1[i] = centres.x1[t];
        centres.y0[i] = centres.y0[t];
        centres.y1[i] = centres.y1[t];
    }
    int hit[most_triangles];
    try_centres(test, corners, centres, unsure_ones, hit);
    for (uint32_t i = 0; i < unsure_ones; ++i)
        state[which[i]] = hit[i];
    const uint32_t* const begin = out;
    for (uint32_t t = 0; t < triangles; ++t) {
        out[0] = indices[3 * t];
        out[1] = indices[3 * t + 1];
        out[2] = indices[3 * t + 2];
        out += state[t] ? 3 : 0;
    }
    return static_cast<size_t>(out - begin);
}

} // namespace prelight::resident
