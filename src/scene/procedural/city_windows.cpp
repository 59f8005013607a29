#include <scene/procedural/city_facade.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

constexpr float pane_depth = 0.17f; ///< of the pane behind the wall's face

/// Frame and bars in front of the pane; uprights stand between the horizontals.
void bars(MeshBuilder& b, glm::vec2 low, glm::vec2 high, Style style) {
    constexpr float w = 0.065f, thin = 0.045f;
    const float back_d = -pane_depth, front_d = -pane_depth + 0.06f, bar_d = -pane_depth + 0.04f;
    const unsigned across = top | bottom | front, along = left | right | front;
    b.box({low.x, low.y, back_d}, {high.x, low.y + w, front_d}, across);
    b.box({low.x, high.y - w, back_d}, {high.x, high.y, front_d}, across);
    const float y0 = low.y + w, y1 = high.y - w;
    b.box({low.x, y0, back_d}, {low.x + w, y1, front_d}, along);
    b.box({high.x - w, y0, back_d}, {high.x, y1, front_d}, along);
    const float middle = (low.x + high.x) / 2;
    const float rail = style == Style::brick ? (low.y + high.y) / 2 : low.y + (high.y - low.y) * 0.7f;
    if (style != Style::modern)
        b.box({low.x + w, rail - thin / 2, back_d}, {high.x - w, rail + thin / 2, bar_d}, across);
    if (style == Style::brick) { // sash: the bar only in the upper half
        b.box({middle - thin / 2, rail + thin / 2, back_d}, {middle + thin / 2, y1, bar_d - 0.01f}, along);
    } else {
        b.box({middle - thin / 2, y0, back_d},
              {middle + thin / 2, style == Style::modern ? y1 : rail - thin / 2, bar_d - 0.01f}, along);
    }
}

/// What stands out around the hole. It covers the reveal's edges and reaches `lip` into the hole.
void surround(MeshBuilder& b, const Facade& f, glm::vec2 low, glm::vec2 high) {
    const unsigned faces = all_faces & ~unsigned{back};
    b.use(Surface::trim, f.trim_tint);
    b.box({low.x - 0.12f, low.y - 0.12f, -0.03f}, {high.x + 0.12f, low.y + lip, 0.14f}, faces);
    const float under = high.y - lip;
    if (f.style == Style::brick) {
        b.box({low.x - 0.14f, under, -0.03f}, {high.x + 0.14f, high.y + 0.24f, 0.035f}, faces);
        const float middle = (low.x + high.x) / 2; // keystone
        b.box({middle - 0.11f, high.y - 0.02f, -0.03f}, {middle + 0.11f, high.y + 0.3f, 0.075f}, faces);
    } else if (f.style == Style::stucco) {
        for (const float s : {low.x - 0.14f, high.x - lip})
            b.box({s, low.y, -0.03f}, {s + 0.14f + lip, under, 0.05f}, left | right | front);
        b.box({low.x - 0.14f, under, -0.03f}, {high.x + 0.14f, high.y + 0.14f, 0.05f}, faces);
        b.box({low.x - 0.22f, high.y + 0.2f, -0.03f}, {high.x + 0.22f, high.y + 0.3f, 0.2f}, faces);
    }
}

void railing(MeshBuilder& b, const Facade& f, glm::vec2 low, glm::vec2 high) {
    const float s0 = low.x - 0.35f, s1 = high.x + 0.35f, y = low.y - 0.2f, out = 0.85f;
    b.use(Surface::trim, f.trim_tint);
    b.box({s0, y - 0.16f, -0.02f}, {s1, y, out}, all_faces & ~unsigned{back});
    b.use(Surface::metal);
    constexpr float t = 0.03f, h = 0.95f, low_rail = 0.1f;
    const unsigned post = left | right | front | back;
    for (const float rail : {low_rail, h}) { // around three sides, corners belong to the front
        b.box({s0, y + rail, out - t}, {s1, y + rail + t, out}, all_faces);
        b.box({s0, y + rail, 0}, {s0 + t, y + rail + t, out - t}, left | right | top | bottom);
        b.box({s1 - t, y + rail, 0}, {s1, y + rail + t, out - t}, left | right | top | bottom);
    }
    constexpr float w = 0.018f;
    const auto count = static_cast<uint32_t>((s1 - s0) / 0.16f);
    for (uint32_t i = 0; i <= count; ++i) {
        const float s = s0 + 0.006f + (s1 - s0 - w - 0.012f) * static_cast<float>(i) / static_cast<float>(count);
        b.box({s, y + low_rail + t, out - 0.024f}, {s + w, y + h, out - 0.006f}, post);
    }
    for (const float s : {s0 + 0.006f, s1 - 0.024f})
        for (uint32_t i = 0; i < 5; ++i) {
            const float d = 0.06f + 0.15f * static_cast<float>(i);
            b.box({s, y + low_rail + t, d}, {s + w, y + h, d + w}, post);
        }
}

} // namespace

void build_window(Plan& plan, MeshBuilder& b, const Facade& f, glm::vec2 low, glm::vec2 high, bool balcony) {
    b.use(f.wall, f.wall_tint);
    reveal(b, low, high, pane_depth);
    const bool lit = plan.chance(0.42);
    const uint32_t cell = lit ? plan.random.below(lit_windows)
                              : lit_windows + plan.random.below(window_cells * window_cells - lit_windows);
    b.use(Surface::window);
    TexRect rect = window_rect(cell);
    if (plan.chance(0.5)) // mirrored rooms look like other ones
        std::swap(rect.lower_left.x, rect.upper_right.x);
    b.quad({low, -pane_depth}, {high.x - low.x, 0, 0}, {0, high.y - low.y, 0}, rect);
    b.use(Surface::frame, f.frame_tint);
    bars(b, low, high, f.style);
    surround(b, f, low, high);
    if (balcony)
        railing(b, f, low, high);
    if (!lit)
        return;
    const glm::vec3 colour = window_light(cell);
    plan.add_point(Rank::window, b.frame.point({(low.x + high.x) / 2, low.y + 0.5f, 0.30f}), colour, 1.1f, 2.4f);
}

} // namespace prelight::city
