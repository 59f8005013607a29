#pragma once
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <prelight/scene.hpp>
#include <string>
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

/// Calls `texel` with the coordinates of each texel's centre, 0 … 1.
TextureImage paint(std::string name, uint32_t width, uint32_t height,
                   const std::function<glm::vec4(glm::vec2)>& texel, bool srgb);
/// Tangent-space normal map of a tileable height field; `metres` is the tile's side, heights too.
TextureImage normal_map(std::string name, const Field& height, uint32_t side, float metres);

} // namespace prelight::city
