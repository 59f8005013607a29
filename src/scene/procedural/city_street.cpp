#include <array>
#include <glm/common.hpp>
#include <numbers>
#include <scene/procedural/city_plan.hpp>

namespace prelight::city {
namespace {

constexpr float paint_height = 0.006f; ///< of a marking above the asphalt
constexpr float corner = 2.5f;         ///< radius of the kerb at the crossing
constexpr uint32_t corner_steps = 8;
constexpr float stone = 0.28f, bevel = 0.03f; ///< a kerb stone's width, its broken edge

/// Horizontal rectangle facing up, x0 … x1, z0 … z1.
void flat(MeshBuilder& b, float x0, float x1, float z0, float z1, float y = 0) {
    b.quad({x0, y, z1}, {x1 - x0, 0, 0}, {0, 0, z0 - z1});
}

/// Asphalt of the main street in tiles of about 12 m, so that each is an object of its own.
void roads(Plan& plan) {
    MeshBuilder b;
    const auto strip = [&](float x0, float x1, float z0, float z1) {
        const bool along_z = z1 - z0 > x1 - x0;
        const float length = along_z ? z1 - z0 : x1 - x0;
        const auto tiles = static_cast<uint32_t>(length / 12 + 0.5f);
        for (uint32_t i = 0; i < tiles; ++i) {
            const float a = static_cast<float>(i) / static_cast<float>(tiles);
            const float c = static_cast<float>(i + 1) / static_cast<float>(tiles);
            b.use(Surface::asphalt);
            if (along_z)
                flat(b, x0, x1, glm::mix(z0, z1, a), glm::mix(z0, z1, c));
            else
                flat(b, glm::mix(x0, x1, a), glm::mix(x0, x1, c), z0, z1);
            plan.build(b, "asphalt");
        }
    };
    // The crossing's square reaches to the houses' corners; the kerbs lie on it.
    const float z0 = cross_z - cross_line, z1 = cross_z + cross_line;
    strip(-house_line, house_line, street_far, z0);
    strip(-house_line, house_line, z1, street_near);
    strip(-house_line, house_line, z0, z1);
    strip(-cross_end, -house_line, z0, z1);
    strip(house_line, cross_end, z0, z1);
}

/// Pavement of `width` metres from the houses at d = 0 to the kerb's face, in a frame whose s runs
/// along the street and d to its axis: slabs, then the kerb stone's top, broken edge and face.
void pavement(MeshBuilder& b, float length, float width) {
    b.use(Surface::paving);
    b.quad({0, kerb_height, width - stone}, {length, 0, 0}, {0, 0, -(width - stone)});
    b.use(Surface::kerb);
    b.quad({0, kerb_height, width - bevel}, {length, 0, 0}, {0, 0, -(stone - bevel)});
    b.quad({0, kerb_height - bevel, width}, {length, 0, 0}, {0, bevel, -bevel});
    b.quad({0, -0.02f, width}, {length, 0, 0}, {0, kerb_height - bevel + 0.02f, 0});
}

/// The quarter at a house's corner at the crossing: a rounded kerb. The frame's origin is the house
/// corner; s and d lead along the two kerbs' normals, away from the house, s × y = d.
void corner_pavement(MeshBuilder& b, float s_width, float d_width) {
    const glm::vec2 centre(s_width - corner, d_width - corner);
    const auto ring = [&](float radius, uint32_t i) {
        const float angle = std::numbers::pi_v<float> / 2 * static_cast<float>(i) / corner_steps;
        return centre + radius * glm::vec2(std::cos(angle), std::sin(angle));
    };
    const auto at = [](glm::vec2 p, float y) { return glm::vec3(p.x, y, p.y); };
    std::vector<glm::vec3> slab{at({0, 0}, kerb_height), at({0, d_width - stone}, kerb_height)};
    for (uint32_t i = corner_steps + 1; i-- > 0;)
        slab.push_back(at(ring(corner - stone, i), kerb_height));
    slab.push_back(at({s_width - stone, 0}, kerb_height));
    // A fan from the house corner: convex, counter-clockwise from above.
    b.use(Surface::paving);
    b.polygon(slab);
    b.use(Surface::kerb);
    const auto line = [&](float inside, float y) { // parallel to the kerb, from end to end
        std::vector<glm::vec3> points{at({s_width - inside, 0}, y)};
        for (uint32_t i = 0; i <= corner_steps; ++i)
            points.push_back(at(ring(corner - inside, i), y));
        points.push_back(at({0, d_width - inside}, y));
        return points;
    };
    const std::array lines{line(0, -0.02f), line(0, kerb_height - bevel), line(bevel, kerb_height),
                           line(stone, kerb_height)};
    for (size_t k = 0; k + 1 < lines.size(); ++k)
        for (size_t i = 0; i + 1 < lines[k].size(); ++i)
            b.polygon(std::array{lines[k][i], lines[k + 1][i], lines[k + 1][i + 1], lines[k][i + 1]});
}

void pavements(Plan& plan) {
    MeshBuilder b;
    const float width = house_line - road_half, cross_width = cross_line - cross_half;
    const float z_near = cross_z + cross_line, z_far = cross_z - cross_line;
    const auto add = [&](const Frame& frame, float length, float wide) {
        b.frame = frame;
        pavement(b, length, wide);
        plan.build(b, "pavement");
        plan.sheets.push_back(
            {{frame.origin + glm::vec3(0, kerb_height, 0) + frame.d * wide, frame.s, -frame.d, {0, 1, 0}},
             {length, wide}});
    };
    for (const glm::vec2& z : {glm::vec2(z_near, street_near), glm::vec2(street_far, z_far)}) {
        add({{-house_line, 0, z.y}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, z.y - z.x, width);
        add({{house_line, 0, z.x}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}, z.y - z.x, width);
    }
    for (const glm::vec2& x : {glm::vec2(-cross_end, -house_line), glm::vec2(house_line, cross_end)}) {
        add({{x.y, 0, z_near}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, x.y - x.x, cross_width);
        add({{x.x, 0, z_far}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, x.y - x.x, cross_width);
    }
    const auto add_corner = [&](const Frame& frame, float s_width, float d_width) {
        b.frame = frame;
        corner_pavement(b, s_width, d_width);
        plan.build(b, "corner pavement");
    };
    add_corner({{-house_line, 0, z_far}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, width, cross_width);
    add_corner({{house_line, 0, z_near}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, width, cross_width);
    add_corner({{-house_line, 0, z_near}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, cross_width, width);
    add_corner({{house_line, 0, z_far}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}, cross_width, width);
}

void markings(Plan& plan) {
    MeshBuilder b;
    b.use(Surface::marking);
    const float stop_near = cross_z + cross_line, stop_far = cross_z - cross_line;
    // Zebra crossings over the four arms.
    for (float x = -road_half + 0.45f; x < road_half - 0.4f; x += 1.0f)
        for (const float z : {stop_near - 0.1f, stop_far + 0.1f - 3.0f})
            flat(b, x, x + 0.5f, z, z + 3.0f, paint_height);
    for (float z = cross_z - cross_half + 0.45f; z < cross_z + cross_half - 0.4f; z += 1.0f)
        for (const float x : {-house_line - 2.8f, house_line})
            flat(b, x, x + 2.8f, z, z + 0.5f, paint_height);
    // Stop lines on the side that drives on the right.
    flat(b, 0.15f, road_half - 0.2f, stop_near + 3.7f, stop_near + 4.1f, paint_height);
    flat(b, -road_half + 0.2f, -0.15f, stop_far - 4.1f, stop_far - 3.7f, paint_height);
    plan.build(b, "crossing markings");

    b.use(Surface::marking);
    for (const glm::vec2& z : {glm::vec2(stop_near + 4.6f, street_near), glm::vec2(street_far, stop_far - 4.6f)}) {
        for (float at = z.y - 1; at - 3 > z.x; at -= 6)
            flat(b, -0.07f, 0.07f, at - 3, at, paint_height);
        for (const float x : {-3.05f, 2.95f}) // parking bays
            flat(b, x, x + 0.1f, z.x, z.y, paint_height);
        for (float at = z.y - 2; at - 0.1f > z.x; at -= 6)
            for (const float x : {-4.85f, 3.05f})
                flat(b, x, x + 1.8f, at - 0.1f, at, paint_height);
    }
    plan.build(b, "lane markings");
}

/// A half dome around the town with the sky on its inner side, and dark land below it.
void surroundings(Plan& plan) {
    constexpr float radius = 320;
    constexpr uint32_t columns = 49, rows = 13;
    MeshBuilder b;
    b.use(Surface::sky);
    std::vector<glm::vec3> points;
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < columns; ++column) {
            const float up = std::numbers::pi_v<float> / 2 * 0.985f * static_cast<float>(row) / (rows - 1);
            const float around =
                2 * std::numbers::pi_v<float> * static_cast<float>(column % (columns - 1)) / (columns - 1);
            points.emplace_back(radius * std::cos(up) * std::cos(around), radius * std::sin(up) - 1.0f,
                                radius * std::cos(up) * std::sin(around));
        }
    b.patch(points, columns);
    Mesh mesh = b.finish("sky");
    for (uint32_t i = 0; i < points.size(); ++i) {
        const uint32_t row = i / columns, column = i % columns;
        mesh.primitives[0].texcoords[0][i] = {3 * static_cast<float>(column) / (columns - 1),
                                              1 - 0.98f * static_cast<float>(row) / (rows - 1) - 0.01f};
    }
    plan.place(plan.add_mesh(std::move(mesh)), {0, 0, -40});
    b.use(Surface::roofing);
    b.frame = {};
    flat(b, -radius, radius, -radius - 40, radius - 40, -0.3f);
    plan.build(b, "land");
}

} // namespace

void add_ground(Plan& plan) {
    roads(plan);
    pavements(plan);
    markings(plan);
    surroundings(plan);
}

} // namespace prelight::city
