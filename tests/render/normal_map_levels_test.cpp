// What mip maps of normal maps keep: the mean normal, and how far normals under a texel lie apart.
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <resident/normal_map_levels.hpp>

namespace prelight {
namespace {

using resident::normal_map_levels;

TextureImage normal_map(uint32_t width, uint32_t height, auto&& normal) {
    TextureImage image{"map", width, height, {}};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::vec3 n = glm::normalize(normal(x, y));
            for (int c = 0; c < 3; ++c)
                image.rgba.push_back(static_cast<uint8_t>(std::lround(127.5f * (n[c] + 1))));
            image.rgba.push_back(255);
        }
    return image;
}

TEST(NormalMapLevels, HalveDownToOneTexel) {
    const auto levels = normal_map_levels(normal_map(12, 5, [](uint32_t, uint32_t) { return glm::vec3(0, 0, 1); }));
    const std::vector<std::pair<uint32_t, uint32_t>> sizes{{12, 5}, {6, 2}, {3, 1}, {1, 1}};
    ASSERT_EQ(levels.size(), sizes.size());
    for (size_t l = 0; l < levels.size(); ++l) {
        EXPECT_EQ(std::pair(levels[l].width, levels[l].height), sizes[l]);
        ASSERT_EQ(levels[l].rgba.size(), size_t(4) * levels[l].width * levels[l].height);
        for (size_t i = 0; i < levels[l].rgba.size(); i += 4) {
            EXPECT_EQ(levels[l].rgba[i + 2], 255) << "a flat map stays flat";
            EXPECT_EQ(levels[l].rgba[i + 3], 0) << "and has lost nothing";
        }
    }
}

TEST(NormalMapLevels, KeepTheVarianceOfSlopes) {
    const float angle = 0.4f;
    const TextureImage image = normal_map(8, 8, [&](uint32_t x, uint32_t) {
        return glm::vec3(x % 2 ? std::sin(angle) : -std::sin(angle), 0, std::cos(angle));
    });
    const auto levels = normal_map_levels(image);
    EXPECT_EQ(levels[0].rgba[3], 0) << "the map itself has lost nothing";
    EXPECT_EQ(levels[0].rgba[0], image.rgba[0]);
    for (size_t l = 1; l < levels.size(); ++l) {
        const double length = std::cos(angle), deviation = std::sqrt((1 - length) / length);
        EXPECT_NEAR(levels[l].rgba[3], 255 * deviation, 1.5) << l;
        EXPECT_NEAR(levels[l].rgba[0], 127.5, 1) << l;
        EXPECT_NEAR(levels[l].rgba[2], 127.5 * (length + 1), 1) << l;
    }
}

} // namespace
} // namespace prelight
