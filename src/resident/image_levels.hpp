#pragma once
#include <algorithm>
#include <cstdint>
#include <image/unorm_byte.hpp>
#include <parallel/parallel_for.hpp>
#include <vector>

namespace prelight::resident {

/// One level of a picture, row by row from the top.
template <class Texel>
struct ImageLevel {
    uint32_t width = 0, height = 0;
    std::vector<Texel> texels{};
};

/// Half as large as a picture, at least 1; each texel the mean of those it covers, an odd side's last one of three.
/// `texel_at(u, v)`: of the picture.
template <class Texel, class TexelAt>
ImageLevel<Texel> halved(uint32_t width, uint32_t height, const TexelAt& texel_at) {
    ImageLevel<Texel> level{std::max(width / 2, 1u), std::max(height / 2, 1u)};
    level.texels.resize(size_t(level.width) * level.height);
    parallel_rows(level.height, [&](uint32_t y) {
        const uint32_t bottom = y + 1 == level.height ? height : 2 * y + 2;
        for (uint32_t x = 0; x < level.width; ++x) {
            const uint32_t right = x + 1 == level.width ? width : 2 * x + 2;
            Texel sum(0);
            for (uint32_t v = 2 * y; v < bottom; ++v)
                for (uint32_t u = 2 * x; u < right; ++u)
                    sum += texel_at(u, v);
            level.texels[size_t(y) * level.width + x] = sum / float((bottom - 2 * y) * (right - 2 * x));
        }
    });
    return level;
}

template <class Texel>
ImageLevel<Texel> halved(const ImageLevel<Texel>& fine) {
    return halved<Texel>(fine.width, fine.height,
                         [&](uint32_t u, uint32_t v) { return fine.texels[size_t(v) * fine.width + u]; });
}

} // namespace prelight::resident
