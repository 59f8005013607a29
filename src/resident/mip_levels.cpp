#include "mip_levels.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <image/srgb_codes.hpp>
#include <parallel/parallel_for.hpp>
#include <prelight/image.hpp>

namespace prelight::resident {
namespace {

/// sRGB codes to linear light in 16 bits and back. Where codes lie closest, in the dark, two of them are 20 steps
/// apart.
struct SrgbTables {
    std::array<uint32_t, 256> linear;
    std::array<uint8_t, 65536> code;

    SrgbTables() {
        for (size_t c = 0; c < linear.size(); ++c)
            linear[c] = static_cast<uint32_t>(std::lround(srgb_linear()[c] * 65535));
        // The nearest code, not that of the nearest light: what a device rounds to.
        for (size_t c = 0, light = 0; c < linear.size(); ++c) {
            const double bound = c == 255 ? 65536 : srgb_decode((static_cast<float>(c) + 0.5f) / 255) * 65535.0;
            for (; light < code.size() && static_cast<double>(light) < bound; ++light)
                code[light] = static_cast<uint8_t>(c);
        }
    }
};

struct Colours { ///< three of sRGB, alpha
    const SrgbTables& tables;
    uint32_t light(const uint8_t* texel, size_t c) const { return c < 3 ? tables.linear[texel[c]] : texel[3]; }
    uint8_t code(uint32_t mean, size_t c) const { return c < 3 ? tables.code[mean] : static_cast<uint8_t>(mean); }
};

struct Values {
    static uint32_t light(const uint8_t* texel, size_t c) { return texel[c]; }
    static uint8_t code(uint32_t mean, size_t) { return static_cast<uint8_t>(mean); }
};

/// A row of the smaller picture from two rows of the larger, or three.
template <class Texels>
void halve_row(const TextureImage& fine, TextureImage& level, uint32_t y, const Texels& texels) {
    const size_t stride = size_t(fine.width) * 4;
    const uint8_t* above = &fine.rgba[2 * y * stride];
    uint8_t* out = &level.rgba[size_t(y) * level.width * 4];
    const uint32_t rows = y + 1 == level.height ? fine.height - 2 * y : 2;
    for (uint32_t x = 0; x < level.width; ++x, above += 8, out += 4) {
        const uint32_t columns = x + 1 == level.width ? fine.width - 2 * x : 2, count = rows * columns;
        for (size_t c = 0; c < 4; ++c) {
            uint32_t sum = count / 2;
            for (size_t v = 0; v < rows; ++v)
                for (size_t u = 0; u < columns; ++u)
                    sum += texels.light(above + v * stride + 4 * u, c);
            out[c] = texels.code(count == 4 ? sum / 4 : sum / count, c);
        }
    }
}

template <class Texels>
TextureImage halved(const TextureImage& fine, const std::string& name, const Texels& texels) {
    TextureImage level{name, std::max(fine.width / 2, 1u), std::max(fine.height / 2, 1u), {}};
    level.rgba.resize(size_t(level.width) * level.height * 4);
    parallel_rows(level.height, [&](uint32_t y) { halve_row(fine, level, y, texels); });
    return level;
}

template <class Texels>
std::vector<TextureImage> levels_of(const TextureImage& image, const Texels& texels) {
    std::vector<TextureImage> levels;
    for (const TextureImage* fine = &image; fine->width > 1 || fine->height > 1; fine = &levels.back()) {
        TextureImage level = halved(*fine, image.name, texels);
        levels.push_back(std::move(level));
    }
    return levels;
}

} // namespace

std::vector<TextureImage> mip_levels(const TextureImage& image, bool srgb) {
    static const SrgbTables tables;
    return srgb ? levels_of(image, Colours{tables}) : levels_of(image, Values{});
}

} // namespace prelight::resident
