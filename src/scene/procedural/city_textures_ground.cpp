#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <scene/procedural/city_noise.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

/// What asphalt is like at a point of its 12 m tile.
struct Asphalt {
    float height; ///< metres
    float stone;  ///< 0 … 1, brightness of the aggregate
    float water;  ///< 0 … 1, depth of standing water
    float crack;  ///< 0 … 1
    float wet;    ///< 0 … 1, film of water
};

Asphalt asphalt_at(glm::vec2, float dents, float shore, float film, float course, float broken, float grains,
                   float gravel, float swell, float ripples) {
    Asphalt a{};
    a.water = ramp(0.59f, 0.655f, dents + 0.05f * (shore - 0.5f));
    a.wet = film;
    // Cracks: where a broad noise crosses its middle, in some places only.
    const float line = std::abs(course - 0.5f);
    a.crack = ramp(0.008f, 0.003f, line) * ramp(0.5f, 0.6f, broken);
    a.stone = grains;
    const float rough = 0.0030f * (a.stone - 0.5f) + 0.0014f * (gravel - 0.5f);
    // Water hides the stones; the wind leaves low ripples on it.
    const float still = 0.0016f * ripples;
    a.height = std::lerp(rough + 0.02f * swell - 0.006f * a.crack, still, a.water);
    return a;
}

constexpr uint32_t asphalt_side = 1024;
constexpr uint32_t paving_side = 512;

/// A pavement slab at a point of the 2 m tile: 4 × 3 slabs in running bond.
struct Slab {
    float height, joint, tone, water;
};

Slab slab_at(glm::vec2 uv, float damp, float grain) {
    const float row = std::floor(uv.y * 4);
    const float shift = static_cast<int>(row) % 2 == 0 ? 0.0f : 0.5f;
    const float x = uv.x * 3 + shift, y = uv.y * 4;
    const float fx = x - std::floor(x), fy = y - row;
    const float edge = std::min(std::min(fx, 1 - fx) * 0.667f, std::min(fy, 1 - fy) * 0.5f); // metres
    Slab s{};
    s.joint = ramp(0.012f, 0.004f, edge);
    const auto column = static_cast<uint32_t>(std::floor(x)) % 3;
    const auto line = static_cast<uint32_t>(row);
    s.tone = hash_unit(column, line, 71);
    s.water = ramp(0.55f, 0.68f, damp);
    s.height = -0.005f * s.joint + 0.0012f * (grain - 0.5f) * (1 - s.water) + 0.004f * (s.tone - 0.5f) * fx;
    return s;
}

} // namespace

void add_ground_pictures(std::vector<TextureImage>& images) {
    // One pass over the tile, three pictures from it.
    const std::vector<Asphalt> asphalt = sample_field(
        asphalt_side, asphalt_at, TileNoise(5, 11, 4), TileNoise(48, 17), TileNoise(9, 23, 3), TileNoise(6, 31, 4),
        TileNoise(7, 37), TileNoise(460, 41), TileNoise(230, 43), TileNoise(12, 47, 3), TileNoise(60, 53));
    images.push_back(paint(
        "asphalt colour", asphalt_side, asphalt_side,
        [&](glm::vec2, size_t i) {
            const Asphalt& a = asphalt[i];
            const float dry = 0.026f + 0.042f * a.stone * a.stone;
            const float v = std::lerp(dry * (0.75f + 0.4f * (1 - a.wet)) * (1 - 0.7f * a.crack), 0.013f, a.water);
            return glm::vec4(v, v * 1.01f, v * 1.05f, 1);
        },
        true));
    images.push_back(paint(
        "asphalt surface", asphalt_side, asphalt_side,
        [&](glm::vec2, size_t i) {
            const Asphalt& a = asphalt[i];
            const float damp = 0.43f - 0.23f * ramp(0.3f, 0.65f, a.wet) + 0.10f * (a.stone - 0.5f);
            return glm::vec4(1, std::lerp(damp, 0.17f, a.water), 0, 1);
        },
        false));
    images.push_back(normal_map("asphalt normal", heights_of(asphalt), asphalt_side, tile_metres(Surface::asphalt)));

    const TileNoise damp(3, 73, 4), grain(170, 79), stains(6, 83, 3);
    const std::vector<Slab> slabs = sample_field(paving_side, slab_at, damp, grain);
    images.push_back(paint(
        "paving colour", paving_side, paving_side,
        [&](glm::vec2, size_t i, float stain) {
            const Slab& s = slabs[i];
            const float stone = 0.13f + 0.07f * s.tone + 0.10f * (stain - 0.5f);
            const float v = std::lerp(stone * (1 - 0.35f * s.water), 0.05f, s.joint);
            return glm::vec4(v, v * 0.97f, v * 0.92f, 1);
        },
        true, stains));
    images.push_back(paint(
        "paving surface", paving_side, paving_side,
        [&](glm::vec2, size_t i) {
            const Slab& s = slabs[i];
            return glm::vec4(1, std::lerp(std::lerp(0.46f + 0.1f * s.tone, 0.22f, s.water), 0.7f, s.joint), 0, 1);
        },
        false));
    images.push_back(normal_map("paving normal", heights_of(slabs), paving_side, tile_metres(Surface::paving)));
}

} // namespace prelight::city
