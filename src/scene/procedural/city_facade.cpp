#include <scene/procedural/city_facade.hpp>

namespace prelight::city {
namespace {

struct Openings {
    float width, height, sill; ///< metres; sill above the floor's line
    uint32_t bays;
};

Openings openings(const Facade& f) {
    switch (f.style) {
    case Style::brick: return {1.15f, 1.85f, 0.75f, static_cast<uint32_t>(f.width / 2.35f)};
    case Style::stucco: return {1.2f, 2.15f, 0.55f, static_cast<uint32_t>(f.width / 2.6f)};
    case Style::modern: return {2.3f, 1.75f, 0.85f, static_cast<uint32_t>(f.width / 3.1f)};
    }
    return {};
}

/// A band across the front: `steps` boxes, each reaching further out than the one below. At ends
/// without a cap it is moved by `lip` out of the side walls' planes, at both the same way, so that
/// it still meets the next house's.
void band(MeshBuilder& b, const Facade& f, float y, float height, float reach, uint32_t steps) {
    for (uint32_t i = 0; i < steps; ++i) {
        const float share = static_cast<float>(i + 1) / static_cast<float>(steps);
        const float out = reach * share;
        const float low = y + height * static_cast<float>(i) / static_cast<float>(steps);
        b.box({f.cap_left ? -out : lip, low, -0.05f},
              {f.width + (f.cap_right ? out : lip), low + height / static_cast<float>(steps), out},
              all_faces & ~unsigned{back});
    }
}

/// Small blocks below the cornice.
void dentils(MeshBuilder& b, const Facade& f, float y) {
    const auto count = static_cast<uint32_t>(f.width / 0.55f);
    const float step = f.width / static_cast<float>(count);
    for (uint32_t i = 0; i < count; ++i) {
        const float s = step * (static_cast<float>(i) + 0.5f);
        b.box({s - 0.11f, y, -0.02f}, {s + 0.11f, y + 0.24f, 0.17f}, all_faces & ~unsigned{back | top});
    }
}

void pilaster(MeshBuilder& b, float s, float width, float low, float high) {
    constexpr float reach = 0.155f; // of base and capital; no dentil of another front ends there
    b.box({s, low, -0.02f}, {s + width, high, 0.10f}, left | right | front);
    b.box({s - 0.05f, low, -0.02f}, {s + width + 0.05f, low + 0.35f, reach}, all_faces & ~unsigned{back});
    b.box({s - 0.05f, high - 0.3f, -0.02f}, {s + width + 0.05f, high, reach}, all_faces & ~unsigned{back});
}

} // namespace

void wall_grid(MeshBuilder& b, const std::vector<float>& s, const std::vector<float>& y,
               const std::vector<bool>& hole) {
    for (size_t row = 0; row + 1 < y.size(); ++row)
        for (size_t column = 0; column + 1 < s.size(); ++column)
            if (!hole[row * (s.size() - 1) + column])
                b.quad({s[column], y[row], 0}, {s[column + 1] - s[column], 0, 0}, {0, y[row + 1] - y[row], 0});
}

void reveal(MeshBuilder& b, glm::vec2 low, glm::vec2 high, float depth) {
    const float w = high.x - low.x, h = high.y - low.y;
    b.quad({low.x, low.y, 0}, {0, 0, -depth}, {0, h, 0});      // faces right
    b.quad({high.x, low.y, -depth}, {0, 0, depth}, {0, h, 0}); // faces left
    b.quad({low.x, high.y, -depth}, {w, 0, 0}, {0, 0, depth}); // faces down
    b.quad({low.x, low.y, 0}, {w, 0, 0}, {0, 0, -depth});      // faces up
}

void build_facade(Plan& plan, MeshBuilder& b, const Facade& f) {
    build_ground_floor(plan, b, f);
    const Openings o = openings(f);
    const float bay = f.width / static_cast<float>(o.bays);
    std::vector<float> s{0}, y{ground_floor};
    for (uint32_t i = 0; i < o.bays; ++i) {
        const float middle = bay * (static_cast<float>(i) + 0.5f);
        s.insert(s.end(), {middle - o.width / 2, middle + o.width / 2});
    }
    s.push_back(f.width);
    for (uint32_t i = 0; i < f.floors; ++i) {
        const float floor = ground_floor + upper_floor * static_cast<float>(i);
        y.insert(y.end(), {floor + o.sill, floor + o.sill + o.height});
    }
    const float height = facade_height(f);
    y.push_back(height);
    std::vector<bool> hole;
    for (size_t row = 0; row + 1 < y.size(); ++row)
        for (size_t column = 0; column + 1 < s.size(); ++column)
            hole.push_back(row % 2 == 1 && column % 2 == 1);
    b.use(f.wall, f.wall_tint);
    wall_grid(b, s, y, hole);
    const uint32_t balcony_bay = plan.random.below(2);
    const bool balconies = f.style != Style::brick && plan.chance(0.7);
    for (size_t row = 1; row + 1 < y.size(); row += 2)
        for (size_t column = 1; column + 1 < s.size(); column += 2)
            build_window(plan, b, f, {s[column], y[row]}, {s[column + 1], y[row + 1]},
                         balconies && row > 1 && column / 2 % 2 == balcony_bay);

    b.use(Surface::trim, f.trim_tint);
    band(b, f, ground_floor - 0.12f, 0.34f, 0.22f, 2);
    if (f.style == Style::modern) {
        for (uint32_t i = 1; i < f.floors; ++i)
            band(b, f, ground_floor + upper_floor * static_cast<float>(i) - 0.1f, 0.2f, 0.06f, 1);
        band(b, f, height - 0.12f, 0.2f, 0.12f, 1);
    } else {
        band(b, f, height - parapet - 0.15f, 0.55f, 0.48f, 3);
        dentils(b, f, height - parapet - 0.39f);
        band(b, f, height - 0.08f, 0.14f, 0.08f, 1);
        if (f.style == Style::stucco)
            for (const float at : {0.12f, f.width - 0.57f})
                pilaster(b, at, 0.45f, ground_floor + 0.22f, height - parapet - 0.39f);
    }
    plan.sheets.push_back({b.frame.at({0, 0.3f, 0}), {f.width, height - 0.3f}});
}

} // namespace prelight::city
