#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <parallel/parallel_for.hpp>
#include <vector>

namespace prelight::resident {

/// One level of a picture, row by row from the top.
template <class Texel>
struct ImageLevel {
    uint32_t width = 0, height = 0;
    std::vector<Texel> texels{};
};

/// 0 … 1 in eight bits.
inline uint8_t unorm_byte(float value) {
    return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

/// Half as large, at least 1; each texel the mean of those it covers, an odd side's last one of three.
template <class Texel>
ImageLevel<Texel> halved(const ImageLevel<Texel>& fine) {
    ImageLevel<Texel> level{std::max(fine.width / 2, 1u), std::max(fine.height / 2, 1u)};
    level.texels.resize(size_t(level.width) * level.height);
    parallel_for(level.height, [&](uint32_t y) {
        const uint32_t bottom = y + 1 == level.height ? fine.height : 2 * y + 2;
        for (uint32_t x = 0; x < level.width; ++x) {
            const uint32_t right = x + 1 == level.width ? fine.width : 2 * x + 2;
            Texel sum(0);
            for (uint32_t v = 2 * y; v < bottom; ++v)
                for (uint32_t u = 2 * x; u < right; ++u)
                    sum += fine.texels[size_t(v) * fine.width + u];
            level.texels[size_t(y) * level.width + x] = sum / float((bottom - 2 * y) * (right - 2 * x));
        }
    });
    return level;
}

} // namespace prelight::resident
