#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <scene/procedural/city_noise.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

constexpr auto glow_count = static_cast<uint32_t>(Glow::count);

/// Road paint, worn: alpha is where it is left.
TextureImage marking_picture() {
    const TileNoise wear(8, 301, 5), grain(128, 310), dirt(16, 320, 3);
    return paint(
        "marking", 512, 512,
        [](glm::vec2, float worn, float grains, float dirty) {
            const float left = ramp(0.34f, 0.42f, worn + 0.22f * (grains - 0.5f));
            const float grey = 0.50f + 0.18f * dirty;
            return glm::vec4(grey, grey, grey * 0.96f, left);
        },
        true, wear, grain, dirt);
}

TextureImage wood_picture() {
    // A stretched lattice: 64 fibres across, 4 along.
    const TileNoise fibres(64, 401), growth(2, 402, 3);
    return paint(
        "wood", 256, 256,
        [&](glm::vec2 uv, float ring) {
            const float grain = fibres({uv.x, std::abs(uv.y - 0.5f) * 0.125f});
            const float rings = 0.5f + 0.5f * std::sin(6.2831853f * (uv.x * 6 + ring));
            const float v = 0.30f + 0.24f * grain + 0.18f * rings;
            return glm::vec4(v, v * 0.52f, v * 0.28f, 1);
        },
        true, growth);
}

/// Awnings: broad stripes, white for the vertex colour and pale.
TextureImage fabric_picture() {
    const TileNoise fade(32, 501);
    return paint(
        "fabric", 128, 128,
        [](glm::vec2 uv, float faded) {
            const float stripe = std::abs(uv.x - 0.5f) < 0.25f ? 1.0f : 0.0f;
            const glm::vec3 c = glm::mix(glm::vec3(0.75f, 0.7f, 0.62f), glm::vec3(0.45f, 0.06f, 0.06f), stripe);
            return glm::vec4(c * (0.85f + 0.15f * faded), 1);
        },
        true, fade);
}

/// A spray of pointed leaves on twigs from the middle, gaps between them.
TextureImage leaves_picture() {
    struct Leaf {
        glm::vec2 centre{0}, axis{0};
        float shade;
    };
    std::vector<Leaf> leaves;
    for (uint32_t i = 0; i < 46; ++i) {
        const float angle = 2.3999632f * static_cast<float>(i); // the golden angle
        const float radius = 0.40f * std::sqrt((static_cast<float>(i) + 0.5f) / 46);
        const float turn = angle + 1.6f * (hash_unit(i, 0, 601) - 0.5f);
        leaves.push_back({glm::vec2(0.5f) + radius * glm::vec2(std::cos(angle), std::sin(angle)),
                          {std::cos(turn), std::sin(turn)},
                          0.55f + 0.45f * hash_unit(i, 1, 602)});
    }
    return paint(
        "leaves", 256, 256,
        [&](glm::vec2 uv) {
            for (const Leaf& leaf : leaves) {
                const glm::vec2 q = uv - leaf.centre;
                const float along = glm::dot(q, leaf.axis) / 0.078f;
                const float across = (q.y * leaf.axis.x - q.x * leaf.axis.y) / 0.030f;
                const float half = 1 - along * along; // pointed at both ends
                if (std::abs(along) < 1 && std::abs(across) < half) {
                    const float vein = std::abs(across) < 0.08f ? 1.35f : 1.0f;
                    const float v = leaf.shade * vein * (0.8f + 0.2f * std::abs(across));
                    return glm::vec4(glm::vec3(0.11f, 0.17f, 0.04f) * v, 1);
                }
            }
            return glm::vec4(0.05f, 0.08f, 0.02f, 0);
        },
        true);
}

glm::vec4 palette_texel(glm::vec2 uv) {
    const auto cell = static_cast<uint32_t>(uv.x * static_cast<float>(glow_count));
    const auto colour = static_cast<Glow>(std::min(cell, glow_count - 1));
    // Tubes are dimmer than lamps: brighter ones would lose their colour in the tone mapper.
    const bool lamp = colour == Glow::warm_white || colour == Glow::cool_white;
    return {glow_colour(colour) * (lamp ? 1.0f : 0.5f), 1};
}

/// Night sky over a town: a glow at the horizon (v = 1), cloud lit from below, a few stars.
glm::vec4 sky_texel(glm::vec2 uv, float clouds, const TileCells& stars) {
    const float up = 1 - uv.y;
    const float glow = std::exp(-up * 7);
    const float cloud = ramp(0.42f, 0.72f, clouds) * (1 - 0.6f * up);
    glm::vec3 c = glm::mix(glm::vec3(0.0035f, 0.006f, 0.017f), glm::vec3(0.045f, 0.032f, 0.040f), glow);
    c += cloud * (glm::vec3(0.010f, 0.011f, 0.020f) + glow * glm::vec3(0.05f, 0.03f, 0.025f));
    const Cellular star = stars(uv);
    if (star.nearest >= 0.09f)
        return {c, 1};
    const float bright = hash_unit(star.cell, 2, 703);
    c += (1 - cloud) * ramp(0.09f, 0.04f, star.nearest) * ramp(0.6f, 1.0f, bright) * ramp(0.1f, 0.5f, up) *
         glm::vec3(0.30f, 0.33f, 0.4f);
    return {c, 1};
}

} // namespace

glm::vec3 glow_colour(Glow colour) {
    constexpr std::array<glm::vec3, glow_count> colours{{{1.0f, 0.74f, 0.42f},
                                                         {0.80f, 0.92f, 1.0f},
                                                         {1.0f, 0.50f, 0.10f},
                                                         {1.0f, 0.035f, 0.02f},
                                                         {1.0f, 0.16f, 0.42f},
                                                         {1.0f, 0.05f, 0.55f},
                                                         {0.50f, 0.10f, 1.0f},
                                                         {0.08f, 0.22f, 1.0f},
                                                         {0.04f, 0.80f, 1.0f},
                                                         {0.08f, 1.0f, 0.28f},
                                                         {1.0f, 0.78f, 0.12f},
                                                         {1.0f, 0.25f, 0.03f}}};
    return colours[static_cast<size_t>(colour)];
}

glm::vec2 palette_uv(Glow colour) {
    return {(static_cast<float>(colour) + 0.5f) / static_cast<float>(glow_count), 0.5f};
}

void add_small_pictures(std::vector<TextureImage>& images) {
    images.push_back(marking_picture());
    images.push_back(wood_picture());
    images.push_back(fabric_picture());
    images.push_back(leaves_picture());
    images.push_back(paint("palette", glow_count * 8, 8, palette_texel, true));
    const TileNoise clouds(4, 701, 6);
    const TileCells stars(110, 702);
    images.push_back(paint(
        "sky", 1024, 512, [&](glm::vec2 uv, float cloud) { return sky_texel(uv, cloud, stars); }, true, clouds));
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
