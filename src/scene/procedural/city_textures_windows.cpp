#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <scene/procedural/city_noise.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

/// A cell's rectangle, half a texel inside, so that linear filtering does not see its neighbours.
TexRect cell_rect(glm::uvec2 cell, glm::uvec2 cells, glm::vec2 texels) {
    const glm::vec2 size = 1.0f / glm::vec2(cells), low = glm::vec2(cell) * size;
    const glm::vec2 inset = 1.5f / texels;
    return {{low.x + inset.x, low.y + size.y - inset.y}, {low.x + size.x - inset.x, low.y + inset.y}};
}

/// 1 inside the ellipse, soft at its edge.
float blob(glm::vec2 p, glm::vec2 centre, glm::vec2 radii) {
    const glm::vec2 q = (p - centre) / radii;
    if (glm::dot(q, q) > 1.13f) // most of the picture: without the root
        return 0;
    return ramp(1.06f, 0.94f, glm::length(q));
}

/// A person from the waist up, `x` across, feet below the window.
float figure(glm::vec2 p, float x, float size) {
    const glm::vec2 q = (p - glm::vec2(x, 0)) / size;
    return std::max(blob(q, {0, 0.62f}, {0.085f, 0.11f}), blob(q, {0, 0.18f}, {0.20f, 0.36f}));
}

/// What all texels of a room share.
struct Room {
    explicit Room(uint32_t number)
        : cell(number), lit(cell < lit_windows), pick(hash_unit(cell, 0, 201)), light(window_light(cell)),
          lamp(0.3f + 0.4f * hash_unit(cell, 1, 202), 0.78f), curtain(0.10f + 0.17f * hash_unit(cell, 3, 203)) {}
    uint32_t cell;
    bool lit;
    float pick; ///< one of a kind, 0 … 1
    glm::vec3 light;
    glm::vec2 lamp;
    float curtain; ///< width at either side
};

/// A room behind a window; p from the lower left corner, 0 … 1.
glm::vec3 room_texel(const Room& room, glm::vec2 p, const TileNoise& foliage) {
    const auto [cell, lit, pick, light, lamp, width] = room;
    const float falloff = 1 / (1 + 3.5f * glm::dot(p - lamp, p - lamp));
    glm::vec3 c = light * (0.25f + 0.95f * falloff);
    if (p.y < 0.2f + 0.1f * pick && lit)
        c *= 0.45f; // furniture below the sill's line
    if (cell % 4 == 1)
        c *= 1 - 0.92f * figure(p, 0.35f + 0.3f * pick, 0.9f);
    if (cell % 5 == 2) // a plant on the sill
        c *= 1 - 0.9f * std::max(blob(p, {0.72f, 0.1f}, {0.07f, 0.1f}),
                                 blob(p, {0.72f, 0.3f}, {0.15f, 0.16f}) * ramp(0.42f, 0.5f, foliage(p)));
    if (cell % 4 == 3) // blinds
        c *= 0.35f + 0.65f * ramp(0.25f, 0.45f, std::abs(p.y * 14 - std::floor(p.y * 14) - 0.5f));
    if (lit && cell % 3 == 0)
        c += light * 2.0f * blob(p, lamp, {0.07f, 0.05f});
    // Curtains to both sides, lit from behind, with folds.
    const float side = std::min(p.x, 1 - p.x);
    if (cell % 4 != 3 && side < width + 0.031f && side - 0.03f * std::sin(p.y * 5) < width) {
        const float folds = 0.62f + 0.38f * std::sin(p.x * 75 + 2 * pick);
        c = glm::mix(c, light * glm::vec3(0.62f, 0.5f, 0.42f) * folds, 0.8f);
    }
    return c;
}

/// What all texels of a shop share.
struct Shop {
    explicit Shop(uint32_t number) : cell(number), light(shop_light(cell)) {
        for (uint32_t i = 0; i < 3; ++i)
            people[i] = {0.15f + 0.33f * static_cast<float>(i) + 0.12f * hash_unit(cell, i, 217),
                         0.62f + 0.1f * hash_unit(cell, i, 218)};
    }
    uint32_t cell;
    glm::vec3 light;
    struct {
        float x, size;
    } people[3]; ///< mannequins or guests
};

/// Behind a shop's window: shelves with goods, or a bar with people.
glm::vec3 shop_texel(const Shop& shop, glm::vec2 p) {
    const uint32_t cell = shop.cell;
    const glm::vec3 light = shop.light;
    const float spots = 0.6f + 0.4f * std::cos(p.x * 6.2831853f * 3);
    glm::vec3 c = light * light * (0.10f + 0.32f * p.y * spots);
    const bool bar = cell % 4 == 1;
    const float shelves = bar ? 6.0f : 4.0f;
    const float y = p.y * shelves, row = std::floor(y), fy = y - row;
    if (p.y < 0.85f && (!bar || p.y > 0.35f)) {
        const float items = bar ? 26.0f : 11.0f + 4 * hash_unit(cell, static_cast<uint32_t>(row), 210);
        const auto id = static_cast<uint32_t>(p.x * items);
        const auto line = static_cast<uint32_t>(row) + 16 * cell;
        const float fx = p.x * items - static_cast<float>(id);
        const float tall = 0.35f + 0.5f * hash_unit(id, line, 211);
        const float wide = 0.30f + 0.18f * hash_unit(id, line, 212);
        if (fy < tall && std::abs(fx - 0.5f) < wide && hash_unit(id, line, 213) > 0.18f) {
            // Muted packages, a few of them loud, with a paler label across each.
            const float tone = hash_unit(id, line, 214), loud = hash_unit(id, line, 215);
            const glm::vec3 hue = 0.5f + 0.5f * glm::cos(6.2831853f * (tone + glm::vec3(0, 0.33f, 0.67f)));
            glm::vec3 goods = glm::mix(glm::vec3(0.30f + 0.3f * tone), hue * hue, loud * loud * 0.8f);
            if (std::abs(fy / tall - 0.55f) < 0.16f)
                goods = glm::mix(goods, glm::vec3(0.8f), 0.5f);
            c = light * goods * (0.35f + 0.5f * p.y);
        }
        if (fy > 0.94f)
            c *= 0.2f; // the board
    }
    const float tone = cell % 2 == 0 ? 0.35f : 0.06f;
    if (cell % 4 != 2)
        for (const auto& [x, size] : shop.people)
            c = glm::mix(c, light * tone * glm::vec3(0.8f, 0.6f, 0.55f), figure(p, x, size));
    return c;
}

} // namespace

TexRect window_rect(uint32_t cell) {
    return cell_rect({cell % window_cells, cell / window_cells}, glm::uvec2(window_cells), glm::vec2(1024));
}

TexRect shop_rect(uint32_t cell) {
    return cell_rect({cell % shop_cells.x, cell / shop_cells.x}, shop_cells, {1024, 512});
}

glm::vec3 window_light(uint32_t cell) {
    constexpr std::array<glm::vec3, 6> lights{{{0.85f, 0.50f, 0.20f},
                                               {0.90f, 0.62f, 0.32f},
                                               {0.80f, 0.40f, 0.12f},
                                               {0.62f, 0.66f, 0.62f},
                                               {0.88f, 0.56f, 0.26f},
                                               {0.25f, 0.40f, 0.75f}}};
    if (cell >= lit_windows)
        return glm::vec3(0.006f, 0.008f, 0.014f);
    return lights[cell % lights.size()] * (0.5f + 0.5f * hash_unit(cell, 7, 220));
}

glm::vec3 shop_light(uint32_t cell) {
    constexpr std::array<glm::vec3, 8> lights{{{0.95f, 0.72f, 0.42f},
                                               {0.85f, 0.40f, 0.14f},
                                               {0.45f, 0.75f, 0.95f},
                                               {0.95f, 0.62f, 0.34f},
                                               {0.95f, 0.80f, 0.55f},
                                               {0.75f, 0.20f, 0.34f},
                                               {0.50f, 0.82f, 0.70f},
                                               {0.95f, 0.78f, 0.50f}}};
    return lights[cell % lights.size()];
}

void add_window_pictures(std::vector<TextureImage>& images) {
    const auto atlas = [](glm::vec2 uv, glm::uvec2 cells, auto&& inside) {
        const glm::vec2 at = uv * glm::vec2(cells), cell = glm::floor(at);
        const glm::vec2 p(at.x - cell.x, 1 - (at.y - cell.y));
        return glm::vec4(inside(static_cast<uint32_t>(cell.y) * cells.x + static_cast<uint32_t>(cell.x), p), 1);
    };
    const TileNoise foliage(17, 204);
    std::vector<Room> rooms;
    for (uint32_t cell = 0; cell < window_cells * window_cells; ++cell)
        rooms.emplace_back(cell);
    std::vector<Shop> shops;
    for (uint32_t cell = 0; cell < shop_cells.x * shop_cells.y; ++cell)
        shops.emplace_back(cell);
    images.push_back(paint(
        "windows", 1024, 1024,
        [&](glm::vec2 uv) {
            return atlas(uv, glm::uvec2(window_cells),
                         [&](uint32_t cell, glm::vec2 p) { return room_texel(rooms[cell], p, foliage); });
        },
        true));
    images.push_back(paint(
        "shops", 1024, 512,
        [&](glm::vec2 uv) {
            return atlas(uv, shop_cells, [&](uint32_t cell, glm::vec2 p) { return shop_texel(shops[cell], p); });
        },
        true));
}

} // namespace prelight::city
