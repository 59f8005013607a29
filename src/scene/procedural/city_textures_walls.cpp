#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <scene/procedural/city_noise.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

constexpr uint32_t side = 512;

/// A wall of 10 × 32 bricks in running bond: 240 × 75 mm each in a tile of 2.4 m.
struct Brick {
    float height, mortar, tone;
};

Brick brick_at(glm::vec2 uv, float edges, float grain) {
    const float row = std::floor(uv.y * 32);
    const float shift = static_cast<int>(row) % 2 == 0 ? 0.0f : 0.5f;
    const float x = uv.x * 10 + shift;
    const float fx = x - std::floor(x), fy = uv.y * 32 - row;
    const float edge = std::min(std::min(fx, 1 - fx) * 0.24f, std::min(fy, 1 - fy) * 0.075f);
    const float ragged = edge + 0.004f * (edges - 0.5f);
    Brick b{};
    b.mortar = ramp(0.0085f, 0.0035f, ragged);
    const auto column = static_cast<uint32_t>(std::floor(x)) % 10;
    b.tone = hash_unit(column, static_cast<uint32_t>(row), 101);
    b.height = -0.007f * b.mortar + 0.002f * (grain - 0.5f) + 0.003f * b.tone;
    return b;
}

} // namespace

void add_wall_pictures(std::vector<TextureImage>& images) {
    const TileNoise edges(128, 107), grain(64, 103, 3), soot_noise(3, 109, 4), plaster_noise(12, 131, 5);
    const std::vector<Brick> bricks = sample_field(side, brick_at, edges, grain);
    images.push_back(paint(
        "brick colour", side, side,
        [&](glm::vec2, size_t i, float grime) {
            const Brick& b = bricks[i];
            const float soot = 0.75f + 0.5f * (grime - 0.25f);
            // Neutral enough for the vertex colour to make it red, ochre or grey.
            const glm::vec3 brick = glm::vec3(0.62f, 0.56f, 0.52f) * (0.65f + 0.5f * b.tone);
            return glm::vec4(glm::mix(brick, glm::vec3(0.45f, 0.43f, 0.40f), b.mortar) * soot, 1);
        },
        true, soot_noise));
    images.push_back(normal_map("brick normal", heights_of(bricks), side, tile_metres(Surface::brick)));

    const Field plaster = sample_field(
        side, [](glm::vec2, float noise) { return 0.016f * noise; }, plaster_noise);
    images.push_back(normal_map("plaster normal", plaster, side, tile_metres(Surface::plaster)));
}

} // namespace prelight::city
