#include "normal_map_levels.hpp"
#include "image_levels.hpp"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace prelight::resident {
namespace {

using NormalLevel = ImageLevel<glm::vec3>; ///< mean unit normals

NormalLevel unit_normals(const TextureImage& image) {
    NormalLevel level{image.width, image.height, std::vector<glm::vec3>(size_t(image.width) * image.height)};
    parallel_for(image.height, [&](uint32_t y) {
        for (size_t i = size_t(y) * image.width, end = i + image.width; i < end; ++i) {
            const glm::vec3 n =
                glm::vec3(image.rgba[4 * i], image.rgba[4 * i + 1], image.rgba[4 * i + 2]) / 127.5f - 1.0f;
            const float length = glm::length(n);
            level.texels[i] = length > 0 ? n / length : glm::vec3(0, 0, 1);
        }
    });
    return level;
}

TextureImage texels_of(const NormalLevel& level, const std::string& name) {
    TextureImage image{name, level.width, level.height, std::vector<uint8_t>(level.texels.size() * 4)};
    parallel_for(level.height, [&](uint32_t y) {
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
    std::vector<TextureImage> levels{image};
    for (size_t alpha = 3; alpha < levels[0].rgba.size(); alpha += 4)
        levels[0].rgba[alpha] = 0;
    NormalLevel level = unit_normals(image);
    while (level.width > 1 || level.height > 1) {
        level = halved(level);
        levels.push_back(texels_of(level, image.name));
    }
    return levels;
}

} // namespace prelight::resident
