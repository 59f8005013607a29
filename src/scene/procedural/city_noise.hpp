#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <parallel/parallel_for.hpp>
#include <prelight/scene.hpp>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace prelight::city {

/// A well mixed 0 ≤ x < 1 for a lattice point.
float hash_unit(uint32_t x, uint32_t y, uint32_t seed);

/// Value noise on a lattice of `period` × `period` points over the unit square, smooth (quintic
/// blend) and continuous over the square's edges; `octaves` of them, each of twice the period and
/// half the weight of the one before. The lattices are tables: a texture asks a million times.
class TileNoise {
public:
    explicit TileNoise(uint32_t period, uint32_t seed, uint32_t octaves = 1);
    /// 0 … 1.
    float operator()(glm::vec2 uv) const;

private:
    friend class NoiseRows;
    struct Octave {
        uint32_t period;
        float weight; ///< the weights' sum is 1
        std::vector<float> lattice;
    };
    std::vector<Octave> octaves_;
};

/// A TileNoise for the centres of a picture's texels, row by row: the same numbers, without finding the lattice's
/// points and the blend between columns for each row anew.
class NoiseRows {
public:
    NoiseRows(const TileNoise& noise, uint32_t width);
    /// One number for each texel of the row at `v`, 0 … 1.
    void row(float v, std::span<float> out) const;

private:
    struct Octave {
        uint32_t period;
        float weight;
        std::vector<float> columns; ///< period × width: each row of the lattice, blended between its columns
    };
    std::vector<Octave> octaves_;
};

struct Cellular {
    float nearest, second; ///< distances in cells
    uint32_t cell;         ///< identifies the nearest point
};
/// Distance field of jittered points, one for each of `period` × `period` cells, tileable.
class TileCells {
public:
    TileCells(uint32_t period, uint32_t seed);
    Cellular operator()(glm::vec2 uv) const;

private:
    uint32_t period_;
    std::vector<glm::vec2> points_; ///< in their cells, with a margin of one cell that repeats the other side
};

/// 0 below `low`, 1 above `high`, smooth between.
inline float ramp(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

using Field = std::vector<float>; ///< side × side numbers, row by row

/// `N` noises along the rows of one picture.
template <size_t N>
class NoiseField {
public:
    NoiseField(uint32_t width, const std::array<const TileNoise*, N>& noises) : width_(width) {
        for (const TileNoise* noise : noises)
            noises_.emplace_back(*noise, width);
    }
    /// Calls `texel` with the number of each column and with the noises there.
    template <typename Texel>
    void row(float v, Texel texel) const {
        std::array<std::vector<float>, N> values;
        for (size_t n = 0; n < N; ++n) {
            values[n].resize(width_);
            noises_[n].row(v, values[n]);
        }
        for (uint32_t x = 0; x < width_; ++x)
            [&]<size_t... I>(std::index_sequence<I...>) { texel(x, values[I][x]...); }
        (std::make_index_sequence<N>{});
    }

private:
    uint32_t width_;
    std::vector<NoiseRows> noises_;
};

/// Side × side values, row by row: `value` of each texel's centre, 0 … 1, and of the noises there; rows in parallel.
template <typename Value, typename... Noise>
auto sample_field(uint32_t side, Value value, const Noise&... noise) {
    const NoiseField<sizeof...(Noise)> noises(side, {&noise...});
    std::vector<decltype(value(glm::vec2(0), (static_cast<void>(noise), 0.0f)...))> field(size_t{side} * side);
    parallel_for(side, [&](uint32_t y) {
        noises.row((static_cast<float>(y) + 0.5f) / static_cast<float>(side), [&](uint32_t x, auto... here) {
            field[size_t{y} * side + x] = value((glm::vec2(x, y) + 0.5f) / static_cast<float>(side), here...);
        });
    });
    return field;
}

/// Calls `row` with the number of each row and the texels to fill, rows in parallel, and encodes them.
TextureImage paint_rows(std::string name, uint32_t width, uint32_t height,
                        const std::function<void(uint32_t, std::span<glm::vec4>)>& row, bool srgb);

/// Calls `texel` with the coordinates of each texel's centre, 0 … 1, with its index when it takes one, and with the
/// noises there; in parallel.
template <typename Texel, typename... Noise>
TextureImage paint(std::string name, uint32_t width, uint32_t height, const Texel& texel, bool srgb,
                   const Noise&... noise) {
    const NoiseField<sizeof...(Noise)> noises(width, {&noise...});
    return paint_rows(
        std::move(name), width, height,
        [&](uint32_t y, std::span<glm::vec4> texels) {
            const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
            noises.row(v, [&](uint32_t x, auto... here) {
                const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(width), v);
                if constexpr (std::is_invocable_v<Texel, glm::vec2, size_t, decltype(here)...>)
                    texels[x] = texel(uv, size_t{y} * width + x, here...);
                else
                    texels[x] = texel(uv, here...);
            });
        },
        srgb);
}

/// The member `height` of each.
template <typename Texel>
Field heights_of(const std::vector<Texel>& texels) {
    Field field(texels.size());
    for (size_t i = 0; i < field.size(); ++i)
        field[i] = texels[i].height;
    return field;
}

/// Tangent-space normal map of a tileable height field; `metres` is the tile's side, heights too.
TextureImage normal_map(std::string name, const Field& height, uint32_t side, float metres);

} // namespace prelight::city
