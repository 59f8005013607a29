#include <algorithm>
#include <array>
#include <scene/procedural/city_facade.hpp>

namespace prelight::city {
namespace {

enum Side : unsigned { east = 1, west = 2, south = 4, north = 8 }; // +x, −x, +z, −z

struct House {
    glm::vec2 low{0}, high{0}; ///< x and z of the footprint
    unsigned fronts;           ///< sides with a façade; the others are plain walls
    uint32_t floors;
    float base = kerb_height; ///< y of the ground floor
};

/// The base of the houses across a street's end: their cornices and sills meet those of the rows
/// at right angles, and would lie in one plane with them.
constexpr float end_base = kerb_height - 0.01f;

/// Frame and width of one side, seen from outside.
std::pair<Frame, float> side_frame(const House& h, Side side) {
    const float w = h.high.x - h.low.x, l = h.high.y - h.low.y, y = h.base;
    switch (side) {
    case east: return {{{h.high.x, y, h.high.y}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, l};
    case west: return {{{h.low.x, y, h.low.y}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}, l};
    case south: return {{{h.low.x, y, h.high.y}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, w};
    default: return {{{h.high.x, y, h.low.y}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, w};
    }
}

/// The sides at the left and the right end of one, seen from outside.
std::pair<Side, Side> neighbours(Side side) {
    switch (side) {
    case east: return {south, north};
    case west: return {north, south};
    case south: return {west, east};
    default: return {east, west};
    }
}

Facade choose_style(Plan& plan) {
    static constexpr std::array<glm::vec3, 5> bricks{{{0.72f, 0.30f, 0.22f},
                                                      {0.85f, 0.62f, 0.40f},
                                                      {0.55f, 0.33f, 0.28f},
                                                      {0.62f, 0.56f, 0.52f},
                                                      {0.90f, 0.50f, 0.32f}}};
    static constexpr std::array<glm::vec3, 5> plasters{{{0.52f, 0.46f, 0.36f},
                                                        {0.42f, 0.45f, 0.46f},
                                                        {0.50f, 0.36f, 0.30f},
                                                        {0.38f, 0.42f, 0.36f},
                                                        {0.55f, 0.52f, 0.48f}}};
    Facade f;
    f.style = static_cast<Style>(plan.scene.meshes.size() % 3); // neighbours differ
    const uint32_t pick = plan.random.below(5);
    f.wall = f.style == Style::brick ? Surface::brick : Surface::plaster;
    f.wall_tint = f.style == Style::brick ? bricks[pick] : 0.82f * plasters[pick];
    if (f.style == Style::modern)
        f.wall_tint = f.wall_tint * 0.75f;
    f.trim_tint = f.style == Style::stucco ? glm::vec3(0.45f, 0.425f, 0.38f) : glm::vec3(0.40f, 0.38f, 0.35f);
    f.frame_tint = f.style == Style::modern ? glm::vec3(0.04f) : glm::vec3(0.5f, 0.48f, 0.44f);
    return f;
}

/// Roof with parapet, chimneys and machines, `top` metres above the ground.
void roof(Plan& plan, MeshBuilder& b, const House& h, const Facade& f, float height) {
    const glm::vec2 size = h.high - h.low;
    constexpr float wall = 0.3f;
    b.frame = {{h.low.x, h.base + height, h.high.y}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    b.use(Surface::trim, f.trim_tint);
    wall_grid(b, {0, wall, size.x - wall, size.x}, {0, wall, size.y - wall, size.y},
              {false, false, false, false, true, false, false, false, false});
    b.use(f.wall, f.wall_tint);
    reveal(b, glm::vec2(wall), size - wall, parapet);
    b.use(Surface::roofing);
    b.quad({wall, wall, -parapet}, {size.x - 2 * wall, 0, 0}, {0, size.y - 2 * wall, 0});
    const unsigned on_roof = all_faces & ~unsigned{back};
    for (uint32_t i = 0; i < 3; ++i) { // stacks with pots
        const float x = plan.uniform(0.6f, size.x - 1.6f), y = plan.uniform(0.6f, size.y - 2.4f);
        const float tall = plan.uniform(0.6f, 1.6f);
        if (plan.chance(0.5)) {
            b.use(Surface::brick, glm::vec3(0.5f, 0.3f, 0.25f));
            b.box({x, y, -parapet}, {x + 0.7f, y + 1.5f, tall}, on_roof);
            b.use(Surface::trim, glm::vec3(0.3f));
            for (const float at : {0.3f, 0.75f, 1.2f})
                b.cone({x + 0.35f, y + at, tall}, {x + 0.35f, y + at, tall + 0.45f}, 0.13f, 0.10f, 10);
        } else {
            b.use(Surface::grating);
            b.box({x, y, -parapet}, {x + 1.1f, y + 1.6f, tall - 0.6f}, on_roof);
        }
    }
}

void build_house(Plan& plan, const House& h) {
    Facade f = choose_style(plan);
    f.floors = h.floors;
    MeshBuilder b;
    for (const Side side : {east, west, south, north}) {
        const auto [frame, width] = side_frame(h, side);
        b.frame = frame;
        f.width = width;
        // At a corner of two façades the one towards ±x carries the cornices around.
        const bool around = side == east || side == west;
        const auto [left_neighbour, right_neighbour] = neighbours(side);
        f.corner_left = h.fronts & left_neighbour;
        f.corner_right = h.fronts & right_neighbour;
        f.cap_left = around && f.corner_left;
        f.cap_right = around && f.corner_right;
        if (h.fronts & side) {
            build_facade(plan, b, f);
        } else {
            b.use(Surface::brick, glm::vec3(0.45f, 0.38f, 0.34f));
            b.quad({0, 0, 0}, {width, 0, 0}, {0, facade_height(f), 0});
        }
    }
    roof(plan, b, h, f, facade_height(f));
    plan.build(b, "house", {(h.low.x + h.high.x) / 2, h.base, (h.low.y + h.high.y) / 2});
}

/// Splits `from` … `to` into lots of 9 to 14 m.
std::vector<float> lots(Plan& plan, float from, float to) {
    std::vector<float> cuts{from};
    while (to - cuts.back() > 23)
        cuts.push_back(cuts.back() + plan.uniform(9.0f, 13.5f));
    if (to - cuts.back() > 14)
        cuts.push_back((cuts.back() + to) / 2);
    cuts.push_back(to);
    return cuts;
}

constexpr float lot_depth = 12;

/// A row along the main street from z0 to z1 (z0 < z1), on the side of `sign`.
void main_row(Plan& plan, float sign, float z0, float z1) {
    const std::vector<float> cuts = lots(plan, z0, z1);
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
        const float x0 = sign * house_line, x1 = sign * (house_line + lot_depth);
        House h{{std::min(x0, x1), cuts[i]},
                {std::max(x0, x1), cuts[i + 1]},
                sign < 0 ? unsigned{east} : unsigned{west},
                3 + plan.random.below(3)};
        if (cuts[i] == cross_z + cross_line)
            h.fronts |= north;
        if (cuts[i + 1] == cross_z - cross_line)
            h.fronts |= south;
        build_house(plan, h);
    }
}

/// A row along the cross street between x0 < x1; `sign` +1: on its +z side, facing −z.
void cross_row(Plan& plan, float sign, float x0, float x1) {
    const std::vector<float> cuts = lots(plan, x0, x1);
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
        const float z0 = cross_z + sign * cross_line, z1 = z0 + sign * lot_depth;
        build_house(plan, {{cuts[i], std::min(z0, z1)},
                           {cuts[i + 1], std::max(z0, z1)},
                           sign > 0 ? unsigned{north} : unsigned{south},
                           3 + plan.random.below(3)});
    }
}

} // namespace

void add_buildings(Plan& plan) {
    constexpr float inner = house_line + lot_depth;
    for (const float sign : {-1.0f, 1.0f}) {
        main_row(plan, sign, cross_z + cross_line, street_near);
        main_row(plan, sign, street_far, cross_z - cross_line);
        cross_row(plan, sign, inner, cross_end);
        cross_row(plan, sign, -cross_end, -inner);
        // The cross street's ends.
        const float x0 = sign * cross_end, x1 = sign * (cross_end + lot_depth);
        build_house(plan, {{std::min(x0, x1), cross_z - 12},
                           {std::max(x0, x1), cross_z + 12},
                           sign > 0 ? unsigned{west} : unsigned{east},
                           4,
                           end_base});
    }
    // What closes the view: a taller house in the street's axis, and one behind the camera.
    build_house(plan, {{-inner, street_far - lot_depth}, {-6.5f, street_far}, south, 4, end_base});
    build_house(plan, {{-6.5f, street_far - lot_depth}, {6.5f, street_far}, south, 8, end_base});
    build_house(plan, {{6.5f, street_far - lot_depth}, {inner, street_far}, south, 5, end_base});
    build_house(plan, {{-inner, street_near}, {0, street_near + lot_depth}, north, 4, end_base});
    build_house(plan, {{0, street_near}, {inner, street_near + lot_depth}, north, 3, end_base});
}

} // namespace prelight::city
