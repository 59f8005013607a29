#include <array>
#include <scene/procedural/city_facade.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

constexpr float head = 3.15f;                     ///< top of the openings
constexpr float shop_depth = 0.42f;               ///< of a shop front behind the wall
constexpr float pier = 0.38f;                     ///< from the end of a shop's unit to its opening
constexpr float corner_pier = shop_depth + 0.06f; ///< keeps the recesses of two fronts apart
constexpr unsigned no_back = all_faces & ~unsigned{back};

/// A door leaf with panels, in a recess; width about 1 m.
void door(MeshBuilder& b, float s0, float s1, float height, float d, glm::vec3 tint) {
    b.use(Surface::wood, tint);
    b.quad({s0, 0.04f, d}, {s1 - s0, 0, 0}, {0, height - 0.04f, 0});
    const float w = s1 - s0;
    for (const glm::vec2& rows : {glm::vec2(0.15f, 0.42f), glm::vec2(0.5f, 0.92f)})
        for (const glm::vec2& columns : {glm::vec2(0.1f, 0.46f), glm::vec2(0.54f, 0.9f)})
            b.box({s0 + w * columns.x, height * rows.x, d - 0.01f}, {s0 + w * columns.y, height * rows.y, d + 0.025f},
                  no_back);
    b.use(Surface::chrome);
    b.sphere({s1 - 0.12f, 1.02f, d + 0.07f}, glm::vec3(0.035f), 10, 6);
}

void awning(MeshBuilder& b, float s0, float s1, glm::vec3 tint) {
    b.use(Surface::fabric, tint);
    const glm::vec3 wall(s0, 3.42f, 0.13f), slope(0, -0.62f, 1.25f), across(s1 - s0, 0, 0);
    const glm::vec3 thick(0, -0.03f, 0), edge = wall + slope;
    b.quad(edge, across, -slope);        // above
    b.quad(wall + thick, across, slope); // below
    const glm::vec3 drop(0, -0.26f, 0);
    b.quad(edge + drop, across, -drop); // the valance, both sides
    b.quad(edge + drop + across - glm::vec3(0, 0, 0.02f), -across, -drop + thick);
    b.polygon(std::array{wall + thick, edge + thick, edge, wall});
    b.polygon(std::array{wall + across, edge + across, edge + thick + across, wall + thick + across});
}

/// The board above a shop with small lamps on arms or a line of light below it.
void fascia(Plan& plan, MeshBuilder& b, float s0, float s1, glm::vec3 tint, glm::vec3 light) {
    b.use(Surface::board, tint);
    b.box({s0, head + 0.22f, -0.02f}, {s1, head + 0.82f, 0.12f}, no_back);
    b.use(Surface::metal);
    b.box({s0 - 0.03f, head + 0.82f, -0.02f}, {s1 + 0.03f, head + 0.9f, 0.18f}, no_back);
    b.use(plan.chance(0.6) ? Glow::warm_white : Glow::cool_white);
    b.box({s0 + 0.1f, head + 0.19f, 0.02f}, {s1 - 0.1f, head + 0.215f, 0.09f}, all_faces);
    // Reaches far enough to be mirrored by the wet street.
    plan.add_point(Rank::shop, b.frame.point({(s0 + s1) / 2, 2.95f, 1.4f}), light, 7, 12);
}

void shop(Plan& plan, MeshBuilder& b, float s0, float s1) {
    static constexpr std::array<glm::vec3, 6> paints{{{0.03f, 0.09f, 0.07f},
                                                      {0.16f, 0.03f, 0.03f},
                                                      {0.025f, 0.05f, 0.12f},
                                                      {0.10f, 0.09f, 0.08f},
                                                      {0.22f, 0.17f, 0.08f},
                                                      {0.03f, 0.03f, 0.035f}}};
    const glm::vec3 paint = paints[plan.random.below(paints.size())];
    const uint32_t cell = plan.random.below(shop_cells.x * shop_cells.y);
    const glm::vec3 light = shop_light(cell);
    const bool door_left = plan.chance(0.5);
    const float door_width = 1.05f;
    constexpr float post_width = 0.1f;
    const float w0 = door_left ? s0 + door_width + post_width : s0;
    const float w1 = door_left ? s1 : s1 - door_width - post_width;
    const float d0 = door_left ? s0 : w1 + post_width, d1 = d0 + door_width;
    const float post = door_left ? d1 : w1;

    b.use(Surface::wood, paint * 2.0f); // riser, and the post beside the door
    b.box({w0, 0, -shop_depth}, {w1, 0.5f, -shop_depth + 0.2f}, no_back & ~unsigned{bottom});
    b.box({post, 0, -shop_depth}, {post + post_width, head, -shop_depth + 0.22f}, left | right | front);
    b.use(Surface::shop);
    TexRect rect = shop_rect(cell);
    b.quad({w0, 0.5f, -shop_depth + 0.08f}, {w1 - w0, 0, 0}, {0, head - 0.5f, 0}, rect);
    b.quad({d0, 0.9f, -shop_depth}, {door_width, 0, 0}, {0, head - 0.9f, 0},
           {rect.lower_left, {glm::mix(rect.lower_left.x, rect.upper_right.x, 0.4f), rect.upper_right.y}});
    b.use(Surface::board, paint); // bars
    const float f0 = -shop_depth + 0.08f, f1 = -shop_depth + 0.16f;
    b.box({w0, head - 0.08f, f0}, {w1, head, f1}, bottom | front);
    b.box({w0, 2.45f, f0}, {w1, 2.52f, f1 - 0.01f}, top | bottom | front);
    const auto panes = static_cast<uint32_t>((w1 - w0) / 1.4f) + 1;
    for (uint32_t i = 0; i <= panes; ++i) {
        const float s = w0 + (w1 - w0 - 0.06f) * static_cast<float>(i) / static_cast<float>(panes);
        b.box({s, 0.5f, f0}, {s + 0.06f, 2.45f, f1}, left | right | front);
    }
    b.use(Surface::wood, paint * 1.7f);
    b.box({d0, 0.03f, -shop_depth - 0.02f}, {d1, 0.9f, -shop_depth + 0.05f}, no_back);
    for (const float s : {d0, d1 - 0.09f})
        b.box({s, 0.9f, -shop_depth - 0.02f}, {s + 0.09f, 2.3f, -shop_depth + 0.05f}, left | right | front);
    b.box({d0, 2.3f, -shop_depth - 0.02f}, {d1, 2.42f, -shop_depth + 0.05f}, top | bottom | front);
    b.use(Surface::chrome);
    b.cone({d0 + 0.14f, 0.95f, -shop_depth + 0.1f}, {d0 + 0.14f, 1.35f, -shop_depth + 0.1f}, 0.015f, 0.015f, 8);

    fascia(plan, b, s0 - 0.05f, s1 + 0.05f, paint, light);
    if (plan.chance(0.35))
        awning(b, s0 + 0.05f, s1 - 0.05f, plan.chance(0.5) ? glm::vec3(1) : glm::vec3(0.3f, 0.9f, 0.8f));
    for (const float share : {0.25f, 0.75f})
        plan.add_point(Rank::shop, b.frame.point({glm::mix(w0, w1, share), 1.5f, 0.35f}), light, 3.2f, 3.8f);
}

/// A rolled-down shutter.
void shutter(MeshBuilder& b, float s0, float s1) {
    b.use(Surface::grating);
    constexpr uint32_t slats = 24;
    for (uint32_t i = 0; i < slats; ++i) {
        const float y = head * static_cast<float>(i) / slats, h = head / slats;
        b.quad({s0, y, -shop_depth + 0.03f}, {s1 - s0, 0, 0}, {0, h * 0.7f, 0.035f});
        b.quad({s0, y + h * 0.7f, -shop_depth + 0.065f}, {s1 - s0, 0, 0}, {0, h * 0.3f, -0.035f});
    }
}

/// A house door with a lamp beside it.
void entrance(Plan& plan, MeshBuilder& b, float s0, float s1) {
    b.use(Surface::trim, glm::vec3(0.35f));
    b.box({s0, 0, -shop_depth}, {s1, 0.04f, 0.25f}, no_back & ~unsigned{bottom});
    const float middle = (s0 + s1) / 2;
    b.use(Surface::frame, glm::vec3(0.12f));
    b.box({s0, 0.04f, -shop_depth}, {middle - 0.6f, head, -shop_depth + 0.1f}, right | front);
    b.box({middle + 0.6f, 0.04f, -shop_depth}, {s1, head, -shop_depth + 0.1f}, left | front);
    door(b, middle - 0.6f, middle + 0.6f, 2.3f, -shop_depth + 0.01f, {0.32f, 0.26f, 0.24f});
    b.use(Surface::window);
    b.quad({middle - 0.6f, 2.3f, -shop_depth + 0.01f}, {1.2f, 0, 0}, {0, head - 2.3f, 0}, window_rect(4));
    b.use(Surface::metal);
    b.box({s1 + 0.1f, 2.18f, -0.02f}, {s1 + 0.18f, 2.24f, 0.2f}, no_back);
    b.use(Glow::warm_white);
    b.sphere({s1 + 0.14f, 2.36f, 0.14f}, glm::vec3(0.10f, 0.12f, 0.10f), 14, 8);
    plan.add_point(Rank::shop, b.frame.point({s1 + 0.14f, 2.36f, 0.4f}), {1, 0.72f, 0.42f}, 5, 4.2f);
}

} // namespace

void build_ground_floor(Plan& plan, MeshBuilder& b, const Facade& f) {
    const uint32_t units = std::max(1u, static_cast<uint32_t>(f.width / 4.6f + 0.5f));
    const float unit = f.width / static_cast<float>(units);
    const uint32_t house_door = plan.random.below(units);
    std::vector<float> s{0};
    std::vector<glm::vec2> openings;
    for (uint32_t i = 0; i < units; ++i) {
        const float start = unit * static_cast<float>(i);
        const bool narrow = i == house_door && units > 1;
        const auto inset = [&](bool corner) { return narrow ? unit / 2 - 1.0f : corner ? corner_pier : pier; };
        openings.emplace_back(start + inset(f.corner_left && i == 0),
                              start + unit - inset(f.corner_right && i + 1 == units));
        s.insert(s.end(), {openings.back().x, openings.back().y});
    }
    s.push_back(f.width);
    std::vector<bool> hole(2 * (s.size() - 1));
    for (size_t column = 1; column + 1 < s.size(); column += 2)
        hole[column] = true;
    const bool stone = f.style != Style::brick;
    b.use(stone ? Surface::plaster : f.wall, stone ? f.trim_tint * 0.8f : f.wall_tint);
    wall_grid(b, s, {0, head, ground_floor}, hole);
    for (const glm::vec2& o : openings)
        reveal(b, {o.x, 0}, {o.y, head}, shop_depth);
    b.use(Surface::trim, f.trim_tint * 0.7f);
    for (size_t i = 0; i < s.size(); i += 2) { // plinths of the piers
        const float low = s[i == 0 ? 0 : i], high = s[i + 1 < s.size() ? i + 1 : i];
        if (high - low > 0.05f && i + 1 < s.size())
            b.box({i == 0 ? lip : low - lip, 0, -0.05f}, {high + lip, 0.45f, 0.06f}, left | right | top | front);
    }
    for (uint32_t i = 0; i < units; ++i) {
        const glm::vec2 o = openings[i];
        if (i == house_door && units > 1)
            entrance(plan, b, o.x, o.y);
        else if (f.shops && plan.chance(0.85))
            shop(plan, b, o.x, o.y);
        else
            shutter(b, o.x, o.y);
    }
}

} // namespace prelight::city
