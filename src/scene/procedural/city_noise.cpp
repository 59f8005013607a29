// Compiled with -O3 (src/CMakeLists.txt): most of a picture are loops over the texels of a row.
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

NoiseRows::NoiseRows(const TileNoise& noise, uint32_t width) {
    for (const TileNoise::Octave& octave : noise.octaves_) {
        const uint32_t n = octave.period;
        std::vector<uint32_t> left(width), right(width);
        std::vector<float> share(width);
        for (uint32_t x = 0; x < width; ++x) {
            const float p = (static_cast<float>(x) + 0.5f) / static_cast<float>(width) * static_cast<float>(n);
            const auto c = static_cast<uint32_t>(p);
            share[x] = fade(p - static_cast<float>(c));
            left[x] = c < n ? c : 0;
            right[x] = left[x] + 1 < n ? left[x] + 1 : 0;
        }
        Octave& made = octaves_.emplace_back(Octave{n, octave.weight, std::vector<float>(size_t{n} * width)});
        for (uint32_t y = 0; y < n; ++y) {
            const float* const lattice = &octave.lattice[size_t{y} * n];
            float* const out = &made.columns[size_t{y} * width];
            for (uint32_t x = 0; x < width; ++x)
                out[x] = lattice[left[x]] + share[x] * (lattice[right[x]] - lattice[left[x]]);
        }
    }
}

void NoiseRows::row(float v, std::span<float> out) const {
    const size_t width = out.size();
    std::fill(out.begin(), out.end(), 0.0f);
    for (const Octave& octave : octaves_) {
        const uint32_t n = octave.period;
        const float p = v * static_cast<float>(n);
        const auto c = static_cast<uint32_t>(p);
        const float share = fade(p - static_cast<float>(c)), weight = octave.weight;
        const uint32_t upper = c < n ? c : 0, lower = upper + 1 < n ? upper + 1 : 0;
        const float* const a = &octave.columns[upper * width];
        const float* const b = &octave.columns[lower * width];
        float* __restrict sum = out.data();
        for (size_t x = 0; x < width; ++x)
            sum[x] += weight * (a[x] + share * (b[x] - a[x]));
    }
}

TileCells::TileCells(uint32_t period, uint32_t seed) : period_(period) {
    for (uint32_t y = 0; y < period + 2; ++y)
        for (uint32_t x = 0; x < period + 2; ++x) {
            const uint32_t column = (x + period - 1) % period, line = (y + period - 1) % period;
            points_.emplace_back(hash_unit(column, line, seed), hash_unit(column, line, seed + 1));
        }
}

Cellular TileCells::operator()(glm::vec2 uv) const {
    const glm::vec2 p = uv * static_cast<float>(period_);
    const auto n = static_cast<int>(period_);
    const auto cx = static_cast<int>(std::floor(p.x)), cy = static_cast<int>(std::floor(p.y));
    const auto column = static_cast<uint32_t>((cx % n + n) % n), line = static_cast<uint32_t>((cy % n + n) % n);
    uint32_t nearest = 0; // of the nine around: 3 · row + column
    Cellular result{9, 9, 0};
    for (uint32_t i = 0; i < 9; ++i) {
        const int dx = static_cast<int>(i % 3) - 1, dy = static_cast<int>(i / 3) - 1;
        const glm::vec2 corner(static_cast<float>(cx + dx), static_cast<float>(cy + dy));
        const float distance = glm::length(corner + points_[(line + i / 3) * (period_ + 2) + column + i % 3] - p);
        if (distance < result.nearest) {
            result.second = result.nearest;
            result.nearest = distance;
            nearest = i;
        } else {
            result.second = std::min(result.second, distance);
        }
    }
    const auto wrapped = [&](uint32_t at) { return (at + period_ - 1) % period_; };
    result.cell = wrapped(line + nearest / 3) * period_ + wrapped(column + nearest % 3);
    return result;
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
        const float* const row = &height[size_t{y} * side];
        const float* const above = &height[size_t{(y + side - 1) % side} * side];
        const float* const below = &height[size_t{(y + 1) % side} * side];
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t right = x + 1 < side ? x + 1 : 0, left = x > 0 ? x - 1 : side - 1;
            const float dx = (row[right] - row[left]) / (2 * texel);
            // Rows run down the picture, the tangent space's Y up.
            const float dy = (above[x] - below[x]) / (2 * texel);
            const glm::vec3 n = glm::normalize(glm::vec3(-dx, -dy, 1));
            for (int i = 0; i < 3; ++i)
                *out++ = to_byte(n[i] * 0.5f + 0.5f);
            *out++ = 255;
        }
    });
    return image;
}

} // namespace prelight::city
