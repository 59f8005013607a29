#include "normal_map_levels.hpp"
#include "image_levels.hpp"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace prelight::resident {
namespace {

using NormalLevel = ImageLevel<glm::vec3>; ///< mean unit normals

glm::vec3 unit_normal(const uint8_t* texel) {
    const glm::vec3 n = glm::vec3(texel[0], texel[1], texel[2]) / 127.5f - 1.0f;
    const float length = glm::length(n);
    return length > 0 ? n / length : glm::vec3(0, 0, 1);
}

TextureImage texels_of(const NormalLevel& level, const std::string& name) {
    TextureImage image{name, level.width, level.height, std::vector<uint8_t>(level.texels.size() * 4)};
    parallel_rows(level.height, [&](uint32_t y) {
        for (size_t i = size_t(y) * level.width, end = i + level.width; i < end; ++i) {
            const glm::vec3 n = level.texels[i];
            const float length = std::clamp(glm::length(n), 1e-6f, 1.0f);
            for (int c = 0; c < 3; ++c)
                image.rgba[4 * i + c] = unorm_byte(n[c] * 0.5f + 0.5f);
            image.rgba[4 * i + 3] = unorm_byte(std::sqrt((1 - length) / length));
        }
    });
    return image;
}

} // namespace

std::vector<TextureImage> normal_map_levels(const TextureImage& image) {
    std::vector<TextureImage> levels;
    levels.push_back(image);
    for (size_t alpha = 3; alpha < levels[0].rgba.size(); alpha += 4)
        levels[0].rgba[alpha] = 0;
    if (image.width == 1 && image.height == 1)
        return levels;
    // The picture's own normals are never there as a whole: they would take three times its memory.
    NormalLevel level = halved<glm::vec3>(image.width, image.height, [&](uint32_t u, uint32_t v) {
        return unit_normal(&image.rgba[4 * (size_t(v) * image.width + u)]);
    });
    for (;;) {
        levels.push_back(texels_of(level, image.name));
        if (level.width == 1 && level.height == 1)
            break;
        level = halved(level);
    }
    return levels;
}

} // namespace prelight::resident
