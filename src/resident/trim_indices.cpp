#include "trim_indices.hpp"
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>

namespace prelight::resident {
namespace {

/// Least and largest value of a row over a box.
struct RowRange {
    double least, most;
};

RowRange over_box(const glm::dvec4& row, const glm::dvec3& middle, const glm::dvec3& half) {
    const double at = glm::dot(glm::dvec3(row), middle) + row.w, reach = glm::dot(glm::abs(glm::dvec3(row)), half);
    return {at - reach, at + reach};
}

} // namespace

void IndexTrimmer::look_from(const TrimView& view) {
    view_ = view;
    // Half a step of the device's grid, and single precision at a few thousand pixels on both sides.
    test_.margin = std::exp2(-static_cast<float>(view.subpixel_bits)) + 1.0f / 128;
    test_.reach = view.samples > 1 ? 0.5f : 0.0f;
    placing_.half_size = {0.5f * view_.width, 0.5f * view_.height};
    // So much beyond the edge of the picture that no rounding brings it back, in units of w.
    placing_.beyond = 1 + 1e-4f + test_.margin / placing_.half_size;
}

void IndexTrimmer::look_at(const Draw& draw, const shared::ObjectData& object) {
    glm::mat4 world(0);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c)
            world[c][r] = object.world_row[r][c];
    world[3][3] = 1;
    placing_.clip = view_.clip_from_world * world;
    // What the device's rounding and ours may differ by in clip space: both grow with the object's own coordinates,
    // also where the object's place takes them away again.
    const glm::vec3 largest = draw.largest();
    glm::vec4 error(0);
    for (int r = 0; r < 4; ++r) {
        for (int k = 0; k < 4; ++k)
            for (int c = 0; c < 4; ++c)
                error[r] += std::abs(view_.clip_from_world[k][r] * world[c][k]) * (c < 3 ? largest[c] : 1.0f);
        error[r] *= 4e-7f;
    }
    placing_.error = error;
    placing_.slack = glm::vec2(error) + 2 * error.w;
    const glm::vec2 inexact = placing_.slack * placing_.half_size * 256.0f; // to a 256th of a pixel
    placing_.least_exact_w = std::max(inexact.x, inexact.y);
}

IndexTrimmer::Place IndexTrimmer::place_of(const Draw& draw) const {
    const glm::dvec3 m = 0.5 * (glm::dvec3(draw.own_low) + glm::dvec3(draw.own_high));
    const glm::dvec3 h = glm::dvec3(draw.own_high) - m;
    const glm::dmat4 clip(placing_.clip);
    const glm::dvec4 row_x = glm::row(clip, 0), row_y = glm::row(clip, 1), row_z = glm::row(clip, 2),
                     row_w = glm::row(clip, 3);
    // As place_vertices() tests vertices, with the error twice: theirs, and that of the test it takes the place of.
    const glm::dvec2 beyond(placing_.beyond), slack = 2.0 * glm::dvec2(placing_.slack);
    const RowRange w = over_box(row_w, m, h), z = over_box(row_z, m, h);
    const RowRange left = over_box(row_x + beyond.x * row_w, m, h);
    const RowRange right = over_box(row_x - beyond.x * row_w, m, h);
    const RowRange top = over_box(row_y + beyond.y * row_w, m, h);
    const RowRange bottom = over_box(row_y - beyond.y * row_w, m, h);
    const RowRange near = over_box(row_z - row_w, m, h);
    const double most_w = std::max(std::abs(w.least), std::abs(w.most));
    const double most_z = std::max(std::abs(z.least), std::abs(z.most));
    const double rounding = 2e-4 * (most_z + most_w) + 2.0 * (double(placing_.error.z) + double(placing_.error.w));
    if (left.most < -slack.x || right.least > slack.x || top.most < -slack.y || bottom.least > slack.y ||
        near.least > rounding || z.most < -rounding)
        return Place::outside;
    const double least_w = std::max(2.0 * double(placing_.least_exact_w), 1e-5);
    if (!(w.least > least_w))
        return Place::crossing;
    // No sample: the box on the screen lies between the centres.
    const double room = double(test_.margin) + double(test_.reach);
    const auto holds_none = [&](const glm::dvec4& row, double half_size) {
        const RowRange range = over_box(row, m, h);
        const double low = half_size + half_size * std::min(range.least / w.least, range.least / w.most);
        const double high = half_size + half_size * std::max(range.most / w.least, range.most / w.most);
        return std::ceil(low - room - 0.5) > std::floor(high + room - 0.5);
    };
    if (holds_none(row_x, double(placing_.half_size.x)) || holds_none(row_y, double(placing_.half_size.y)))
        return Place::outside;
    const bool within = left.least > slack.x && right.most < -slack.x && top.least > slack.y && bottom.most < -slack.y;
    return within ? Place::inside : Place::crossing;
}

size_t IndexTrimmer::trim(const Draw& draw, const shared::ObjectData& object, uint32_t* out) {
    const Primitive& primitive = *draw.primitive;
    // Fronts are counter-clockwise in the picture, and clockwise where the object is mirrored.
    const float front = draw.mirrored ? 1.0f : -1.0f;
    test_.facing = draw.double_sided || view_.both_faces ? 0.0f : front;
    const size_t vertices = primitive.positions.size();
    if (x_.size() < vertices) {
        x_.resize(vertices);
        y_.resize(vertices);
        outside_.resize(vertices);
    }
    look_at(draw, object);
    const Place place = place_of(draw);
    if (place == Place::outside)
        return 0;
    const ScreenVertices screen{x_.data(), y_.data(), place == Place::inside ? nullptr : outside_.data()};
    place_vertices(placing_, primitive.positions.data(), vertices, {x_.data(), y_.data(), outside_.data()});
    const uint32_t* const begin = out;
    const size_t triangles = primitive.indices.size() / 3;
    for (size_t t = 0; t < triangles; t += most_triangles)
        out += select_triangles(test_, &primitive.indices[3 * t],
                                static_cast<uint32_t>(std::min<size_t>(most_triangles, triangles - t)), screen, out);
    return static_cast<size_t>(out - begin);
}

} // namespace prelight::resident
