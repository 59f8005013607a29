#include "trim_indices.hpp"
#include <algorithm>
#include <cmath>

namespace prelight::resident {
namespace {

// A triangle whose corners share one of the first six bits is off screen.
constexpr uint8_t outside_left = 1, outside_right = 2, outside_top = 4, outside_bottom = 8, outside_near = 16,
                  outside_far = 32;
/// Behind the camera, or so far off that single precision does not tell where: its triangles are kept.
constexpr uint8_t unknown_place = 64;
constexpr float farthest = 16384; ///< pixels from the picture's corner

/// Twice the signed area, positive when clockwise on a screen whose y points down.
float turn(glm::vec2 a, glm::vec2 b, glm::vec2 c) { return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y); }

/// No centre of a few pixels lies in the triangle or within `margin` of it.
bool misses_centres(const glm::vec2 (&p)[3], float margin, int x0, int x1, int y0, int y1) {
    const float sign = turn(p[0], p[1], p[2]) < 0 ? -1.0f : 1.0f;
    struct Edge {
        float a, b, c;
    } edges[3];
    for (int i = 0; i < 3; ++i) {
        const glm::vec2 from = p[i], to = p[(i + 1) % 3];
        const float a = -sign * (to.y - from.y), b = sign * (to.x - from.x);
        // Both ends may be off by the margin, and so may the sum's rounding be.
        edges[i] = {a, b, -(a * from.x + b * from.y) + 2 * margin * (std::abs(a) + std::abs(b) + margin)};
    }
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const float cx = static_cast<float>(x) + 0.5f, cy = static_cast<float>(y) + 0.5f;
            bool inside = true;
            for (const Edge& e : edges)
                inside &= e.a * cx + e.b * cy + e.c >= 0;
            if (inside)
                return false;
        }
    return true;
}

} // namespace

IndexTrimmer::IndexTrimmer(const TrimView& view)
    // Half a step of the device's grid, and single precision at a few thousand pixels on both sides.
    : view_(view),
      margin_(std::exp2(-static_cast<float>(view.subpixel_bits)) + 1.0f / 128 + (view.samples > 1 ? 0.5f : 0.0f)) {}

void IndexTrimmer::project(const Primitive& primitive, const shared::ObjectData& object) {
    const size_t count = primitive.positions.size();
    place_.resize(count);
    outside_.resize(count);
    glm::mat4 world(0);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c)
            world[c][r] = object.world_row[r][c];
    world[3][3] = 1;
    const glm::mat4 clip = view_.clip_from_world * world;
    // What the device's rounding and ours may differ by in clip space: both grow with the object's own coordinates,
    // also where the object's place takes them away again.
    glm::vec3 largest(0);
    for (const glm::vec3& position : primitive.positions)
        largest = glm::max(largest, glm::abs(position));
    glm::vec4 error(0);
    for (int r = 0; r < 4; ++r) {
        for (int k = 0; k < 4; ++k)
            for (int c = 0; c < 4; ++c)
                error[r] += std::abs(view_.clip_from_world[k][r] * world[c][k]) * (c < 3 ? largest[c] : 1.0f);
        error[r] *= 4e-7f;
    }
    const glm::vec2 slack = glm::vec2(error) + 2 * error.w;
    const float half_width = 0.5f * view_.width, half_height = 0.5f * view_.height;
    // So much beyond the edge of the picture that no rounding brings it back, in units of w.
    const float beyond_x = 1 + 1e-4f + margin_ / half_width, beyond_y = 1 + 1e-4f + margin_ / half_height;
    for (size_t v = 0; v < count; ++v) {
        const glm::vec4 p = clip * glm::vec4(primitive.positions[v], 1);
        uint8_t outside = 0;
        outside |= p.x < -p.w * beyond_x - slack.x ? outside_left : 0;
        outside |= p.x > p.w * beyond_x + slack.x ? outside_right : 0;
        outside |= p.y < -p.w * beyond_y - slack.y ? outside_top : 0;
        outside |= p.y > p.w * beyond_y + slack.y ? outside_bottom : 0;
        const float rounding = 1e-4f * (std::abs(p.z) + std::abs(p.w)) + error.z + error.w;
        outside |= p.z > p.w + rounding ? outside_near : 0;
        outside |= p.z < -rounding ? outside_far : 0;
        const glm::vec2 place(half_width + half_width * p.x / p.w, half_height + half_height * p.y / p.w);
        const bool exact = std::max(slack.x * half_width, slack.y * half_height) * 256 < p.w; // to a 256th of a pixel
        const bool known = exact && p.w > 1e-6f && std::abs(place.x) < farthest && std::abs(place.y) < farthest;
        place_[v] = known ? place : glm::vec2(0);
        outside_[v] = known ? outside : static_cast<uint8_t>(outside | unknown_place);
    }
}

template <bool double_sided>
size_t IndexTrimmer::select(const std::vector<uint32_t>& indices, float facing, uint32_t* out) const {
    const uint32_t* const begin = out;
    for (size_t t = 0; t + 2 < indices.size(); t += 3) {
        const uint32_t a = indices[t], b = indices[t + 1], c = indices[t + 2];
        if (outside_[a] & outside_[b] & outside_[c] & ~unknown_place)
            continue;
        if (!((outside_[a] | outside_[b] | outside_[c]) & unknown_place)) {
            const glm::vec2 p[3] = {place_[a], place_[b], place_[c]};
            const float low_x = std::min({p[0].x, p[1].x, p[2].x}), high_x = std::max({p[0].x, p[1].x, p[2].x});
            const float low_y = std::min({p[0].y, p[1].y, p[2].y}), high_y = std::max({p[0].y, p[1].y, p[2].y});
            if constexpr (!double_sided) {
                const float slack = 2 * margin_ * (high_x - low_x + high_y - low_y + margin_);
                if (facing * turn(p[0], p[1], p[2]) < -slack)
                    continue;
            }
            // The pixels whose centres lie in the box around it.
            const int x0 = static_cast<int>(std::ceil(low_x - margin_ - 0.5f));
            const int x1 = static_cast<int>(std::floor(high_x + margin_ - 0.5f));
            const int y0 = static_cast<int>(std::ceil(low_y - margin_ - 0.5f));
            const int y1 = static_cast<int>(std::floor(high_y + margin_ - 0.5f));
            if (x0 > x1 || y0 > y1)
                continue;
            if ((x1 - x0 + 1) * (y1 - y0 + 1) <= 6 && misses_centres(p, margin_, x0, x1, y0, y1))
                continue;
        }
        *out++ = a;
        *out++ = b;
        *out++ = c;
    }
    return static_cast<size_t>(out - begin);
}

size_t IndexTrimmer::trim(const Primitive& primitive, const shared::ObjectData& object, bool mirrored,
                          bool double_sided, uint32_t* out) {
    project(primitive, object);
    // Fronts are counter-clockwise in the picture, and clockwise where the object is mirrored.
    const float facing = mirrored ? 1.0f : -1.0f;
    return double_sided ? select<true>(primitive.indices, facing, out) : select<false>(primitive.indices, facing, out);
}

} // namespace prelight::resident
