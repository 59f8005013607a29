#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <prelight/image.hpp>
#include <scene/procedural/city_noise.hpp>

namespace prelight::city {
namespace {

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

uint8_t to_byte(float x) { return static_cast<uint8_t>(std::clamp(x, 0.0f, 1.0f) * 255 + 0.5f); }

} // namespace

float hash_unit(uint32_t x, uint32_t y, uint32_t seed) {
    // Two rounds of a 32-bit mixer (the finaliser of MurmurHash3).
    uint32_t h = x * 0x9e3779b1u ^ (y * 0x85ebca77u + seed * 0xc2b2ae3du);
    for (int round = 0; round < 2; ++round) {
        h = (h ^ (h >> 16)) * 0x85ebca6bu;
        h = (h ^ (h >> 13)) * 0xc2b2ae35u;
        h ^= h >> 16;
    }
    return static_cast<float>(h >> 8) * 0x1p-24f;
}

TileNoise::TileNoise(uint32_t period, uint32_t seed, uint32_t octaves) {
    const float total = 2 - std::exp2(1 - static_cast<float>(octaves)); // 1 + 1/2 + …
    for (uint32_t i = 0; i < octaves; ++i) {
        Octave octave{period << i, std::exp2(-static_cast<float>(i)) / total, {}};
        for (uint32_t y = 0; y < octave.period; ++y)
            for (uint32_t x = 0; x < octave.period; ++x)
                octave.lattice.push_back(hash_unit(x, y, seed + i));
        octaves_.push_back(std::move(octave));
    }
}

float TileNoise::operator()(glm::vec2 uv) const {
    float sum = 0;
    uv -= glm::floor(uv);
    for (const Octave& octave : octaves_) {
        const uint32_t n = octave.period;
        const glm::vec2 p = uv * static_cast<float>(n);
        const auto cx = static_cast<uint32_t>(p.x), cy = static_cast<uint32_t>(p.y);
        const float fx = fade(p.x - static_cast<float>(cx));
        const float fy = fade(p.y - static_cast<float>(cy));
        // Rounding can make uv · n equal to n.
        const uint32_t x0 = cx < n ? cx : 0, x1 = x0 + 1 < n ? x0 + 1 : 0;
        const uint32_t y0 = cy < n ? cy : 0, y1 = y0 + 1 < n ? y0 + 1 : 0;
        const float* row0 = &octave.lattice[size_t{y0} * n];
        const float* row1 = &octave.lattice[size_t{y1} * n];
        const float a = row0[x0] + fx * (row0[x1] - row0[x0]);
        const float b = row1[x0] + fx * (row1[x1] - row1[x0]);
        sum += octave.weight * (a + fy * (b - a));
    }
    return sum;
}

Cellular tile_cells(glm::vec2 uv, uint32_t period, uint32_t seed) {
    const glm::vec2 p = uv * static_cast<float>(period);
    const auto n = static_cast<int>(period);
    const auto cx = static_cast<int>(std::floor(p.x)), cy = static_cast<int>(std::floor(p.y));
    Cellular result{9, 9, 0};
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const auto x = static_cast<uint32_t>(((cx + dx) % n + n) % n);
            const auto y = static_cast<uint32_t>(((cy + dy) % n + n) % n);
            const glm::vec2 point(static_cast<float>(cx + dx) + hash_unit(x, y, seed),
                                  static_cast<float>(cy + dy) + hash_unit(x, y, seed + 1));
            const float distance = glm::length(point - p);
            if (distance < result.nearest) {
                result.second = result.nearest;
                result.nearest = distance;
                result.cell = y * period + x;
            } else {
                result.second = std::min(result.second, distance);
            }
        }
    return result;
}

float ramp(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

TextureImage paint_rows(std::string name, uint32_t width, uint32_t height,
                        const std::function<void(uint32_t, std::span<glm::vec4>)>& row, bool srgb) {
    // Encoding through a table: a million calls of a power function would take longer than the
    // noise.
    std::vector<uint8_t> encode(4097);
    for (size_t i = 0; i < encode.size(); ++i) {
        const float x = static_cast<float>(i) / 4096;
        encode[i] = to_byte(srgb ? srgb_encode(x * x) : x * x);
    }
    TextureImage image{std::move(name), width, height, {}};
    image.rgba.resize(size_t{4} * width * height);
    parallel_for(height, [&](uint32_t y) {
        std::vector<glm::vec4> texels(width);
        row(y, texels);
        uint8_t* out = &image.rgba[size_t{4} * width * y];
        for (const glm::vec4& c : texels) {
            for (int i = 0; i < 3; ++i) {
                // The table is indexed by the square root, which spreads the dark end.
                const float root = std::sqrt(std::clamp(c[i], 0.0f, 1.0f));
                *out++ = encode[static_cast<size_t>(root * 4096 + 0.5f)];
            }
            *out++ = to_byte(c.a);
        }
    });
    return image;
}

TextureImage normal_map(std::string name, const Field& height, uint32_t side, float metres) {
    TextureImage image{std::move(name), side, side, {}};
    image.rgba.resize(size_t{4} * side * side);
    const float texel = metres / static_cast<float>(side);
    parallel_for(side, [&](uint32_t y) {
        uint8_t* out = &image.rgba[size_t{4} * side * y];
        for (uint32_t x = 0; x < side; ++x) {
            const auto at = [&](uint32_t column, uint32_t row) {
                return height[size_t{row % side} * side + column % side];
            };
            const float dx = (at(x + 1, y) - at(x + side - 1, y)) / (2 * texel);
            // Rows run down the picture, the tangent space's Y up.
            const float dy = (at(x, y + side - 1) - at(x, y + 1)) / (2 * texel);
            const glm::vec3 n = glm::normalize(glm::vec3(-dx, -dy, 1));
            for (int i = 0; i < 3; ++i)
                *out++ = to_byte(n[i] * 0.5f + 0.5f);
            *out++ = 255;
        }
    });
    return image;
}

} // namespace prelight::city
