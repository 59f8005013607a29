#pragma once
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <parallel/parallel_for.hpp>
#include <prelight/scene.hpp>
#include <span>
#include <string>
#include <type_traits>
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
    struct Octave {
        uint32_t period;
        float weight; ///< the weights' sum is 1
        std::vector<float> lattice;
    };
    std::vector<Octave> octaves_;
};

/// Distance field of jittered points, one for each of `period` × `period` cells, tileable.
struct Cellular {
    float nearest, second; ///< distances in cells
    uint32_t cell;         ///< identifies the nearest point
};
Cellular tile_cells(glm::vec2 uv, uint32_t period, uint32_t seed);

/// 0 below `low`, 1 above `high`, smooth between.
float ramp(float low, float high, float x);

using Field = std::vector<float>; ///< side × side numbers, row by row

/// Side × side values, row by row: `value` of each texel's centre, 0 … 1; rows in parallel.
template <typename Value>
auto sample_field(uint32_t side, Value value) {
    std::vector<decltype(value(glm::vec2(0)))> field(size_t{side} * side);
    parallel_for(side, [&](uint32_t y) {
        for (uint32_t x = 0; x < side; ++x)
            field[size_t{y} * side + x] = value((glm::vec2(x, y) + 0.5f) / static_cast<float>(side));
    });
    return field;
}

/// Calls `row` with the number of each row and the texels to fill, rows in parallel, and encodes them.
TextureImage paint_rows(std::string name, uint32_t width, uint32_t height,
                        const std::function<void(uint32_t, std::span<glm::vec4>)>& row, bool srgb);

/// Calls `texel` with the coordinates of each texel's centre, 0 … 1, and with its index when it takes
/// one; in parallel.
template <typename Texel>
TextureImage paint(std::string name, uint32_t width, uint32_t height, const Texel& texel, bool srgb) {
    return paint_rows(
        std::move(name), width, height,
        [&](uint32_t y, std::span<glm::vec4> texels) {
            for (uint32_t x = 0; x < width; ++x) {
                const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                   (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
                if constexpr (std::is_invocable_v<Texel, glm::vec2, size_t>)
                    texels[x] = texel(uv, size_t{y} * width + x);
                else
                    texels[x] = texel(uv);
            }
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
