#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <scene/procedural/city_noise.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

constexpr auto glow_count = static_cast<uint32_t>(Glow::count);

/// Road paint, worn: alpha is where it is left.
glm::vec4 marking_texel(glm::vec2 uv) {
    const float wear = tile_fbm(uv, 8, 5, 301), grain = tile_noise(uv, 128, 310);
    const float left = ramp(0.36f, 0.44f, wear + 0.22f * (grain - 0.5f));
    const float grey = 0.50f + 0.18f * tile_fbm(uv, 16, 3, 320);
    return {grey, grey, grey * 0.96f, left};
}

glm::vec4 wood_texel(glm::vec2 uv) {
    const float grain = tile_noise({uv.x, uv.y * 0.0625f}, 64, 401);
    const float rings = 0.5f + 0.5f * std::sin(6.2831853f * (uv.x * 6 + tile_fbm(uv, 2, 3, 402)));
    const float v = 0.10f + 0.08f * grain + 0.06f * rings;
    return {v, v * 0.52f, v * 0.28f, 1};
}

/// Awnings: broad stripes, white for the vertex colour and pale.
glm::vec4 fabric_texel(glm::vec2 uv) {
    const float stripe = std::abs(uv.x - 0.5f) < 0.25f ? 1.0f : 0.0f;
    const glm::vec3 c = glm::mix(glm::vec3(0.75f, 0.7f, 0.62f), glm::vec3(0.45f, 0.06f, 0.06f),
                                 stripe) * (0.85f + 0.15f * tile_noise(uv, 32, 501));
    return {c, 1};
}

/// A spray of pointed leaves with gaps between them.
glm::vec4 leaves_texel(glm::vec2 uv) {
    const Cellular cells = tile_cells(uv, 7, 601);
    const float shade = 0.6f + 0.4f * hash_unit(cells.cell, 1, 602);
    const float edge = cells.second - cells.nearest;
    const glm::vec2 c = uv * 2.0f - 1.0f;
    const bool inside = edge > 0.16f && cells.nearest < 0.72f &&
                        glm::dot(c, c) < 0.75f + 0.5f * tile_noise(uv, 9, 603);
    const glm::vec3 green = glm::vec3(0.10f, 0.17f, 0.035f) * shade * (0.7f + edge);
    return {green, inside ? 1.0f : 0.0f};
}

glm::vec4 palette_texel(glm::vec2 uv) {
    const auto cell = static_cast<uint32_t>(uv.x * static_cast<float>(glow_count));
    return {glow_colour(static_cast<Glow>(std::min(cell, glow_count - 1))), 1};
}

/// Night sky over a town: a glow at the horizon (v = 1), cloud lit from below, a few stars.
glm::vec4 sky_texel(glm::vec2 uv) {
    const float up = 1 - uv.y;
    const float glow = std::exp(-up * 7);
    const float cloud = ramp(0.42f, 0.72f, tile_fbm(uv, 4, 6, 701)) * (1 - 0.6f * up);
    glm::vec3 c = glm::mix(glm::vec3(0.0035f, 0.006f, 0.017f), glm::vec3(0.045f, 0.032f, 0.040f), glow);
    c += cloud * (glm::vec3(0.010f, 0.011f, 0.020f) + glow * glm::vec3(0.05f, 0.03f, 0.025f));
    const Cellular star = tile_cells(uv, 90, 702);
    const float bright = hash_unit(star.cell, 2, 703);
    c += (1 - cloud) * ramp(0.10f, 0.03f, star.nearest) * bright * bright * ramp(0.1f, 0.5f, up) *
         glm::vec3(0.30f, 0.33f, 0.4f);
    return {c, 1};
}

} // namespace

glm::vec3 glow_colour(Glow colour) {
    constexpr std::array<glm::vec3, glow_count> colours{{{1.0f, 0.74f, 0.42f}, {0.80f, 0.92f, 1.0f},
        {1.0f, 0.50f, 0.10f}, {1.0f, 0.035f, 0.02f}, {1.0f, 0.16f, 0.42f}, {1.0f, 0.05f, 0.55f},
        {0.50f, 0.10f, 1.0f}, {0.08f, 0.22f, 1.0f}, {0.04f, 0.80f, 1.0f}, {0.08f, 1.0f, 0.28f},
        {1.0f, 0.78f, 0.12f}, {1.0f, 0.25f, 0.03f}}};
    return colours[static_cast<size_t>(colour)];
}

glm::vec2 palette_uv(Glow colour) {
    return {(static_cast<float>(colour) + 0.5f) / static_cast<float>(glow_count), 0.5f};
}

void add_small_pictures(std::vector<TextureImage>& images) {
    images.push_back(paint("marking", 512, 512, marking_texel, true));
    images.push_back(paint("wood", 256, 256, wood_texel, true));
    images.push_back(paint("fabric", 128, 128, fabric_texel, true));
    images.push_back(paint("leaves", 256, 256, leaves_texel, true));
    images.push_back(paint("palette", glow_count * 8, 8, palette_texel, true));
    images.push_back(paint("sky", 1024, 512, sky_texel, true));
}

std::vector<TextureImage> make_pictures() {
    std::vector<TextureImage> images;
    add_ground_pictures(images);
    add_wall_pictures(images);
    add_window_pictures(images);
    add_small_pictures(images);
    return images;
}

} // namespace prelight::city
