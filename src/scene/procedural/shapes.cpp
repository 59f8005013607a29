#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <scene/procedural/shapes.hpp>

namespace prelight {
namespace {

/// Two triangles for each cell of a (columns + 1) × (rows + 1) grid of vertices stored row by row from `first` on;
/// counter-clockwise where the columns run to the right and the rows run down.
void add_grid_indices(Primitive& primitive, uint32_t columns, uint32_t rows, uint32_t first = 0) {
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t a = first + row * (columns + 1) + column;
            const uint32_t b = a + columns + 1;
            primitive.indices.insert(primitive.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
}

/// k / n of a turn, exact at the quarters, so that poles and seams meet.
glm::dvec2 cos_sin(uint32_t k, uint32_t n) {
    constexpr std::array<glm::dvec2, 4> quarters{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    if (4 * k % n == 0)
        return quarters[4 * k / n % 4];
    const double angle = 2 * std::numbers::pi * k / n;
    return {std::cos(angle), std::sin(angle)};
}

} // namespace

Primitive make_sphere(float radius, uint32_t slices, uint32_t stacks) {
    Primitive sphere;
    for (uint32_t row = 0; row <= stacks; ++row)
        for (uint32_t column = 0; column <= slices; ++column) {
            const glm::dvec2 polar = cos_sin(row, 2 * stacks);
            const glm::dvec2 around = cos_sin(column, slices);
            const glm::vec3 normal(polar.y * around.x, polar.x, -polar.y * around.y);
            sphere.positions.push_back(radius * normal);
            sphere.normals.push_back(normal);
            sphere.texcoords[0].emplace_back(static_cast<double>(column) / slices, static_cast<double>(row) / stacks);
        }
    add_grid_indices(sphere, slices, stacks);
    return sphere;
}

Primitive make_knot(float size, float tube, uint32_t along, uint32_t around) {
    constexpr double repeats = 16;
    // Twice about the axis, three times about the ring.
    const auto curve = [&](double turn) {
        const double about = 2 * full_turn * turn, over = 3 * full_turn * turn;
        const double radius = size * (1 + 0.5 * std::cos(over));
        return glm::dvec3(radius * std::cos(about), radius * std::sin(about), 0.5 * size * std::sin(over));
    };
    Primitive knot;
    for (uint32_t row = 0; row <= around; ++row)
        for (uint32_t column = 0; column <= along; ++column) {
            const double turn = double(column % along) / along;
            constexpr double step = 1e-4;
            const glm::dvec3 centre = curve(turn);
            const glm::dvec3 tangent = glm::normalize(curve(turn + step) - curve(turn - step));
            // Up from the torus' own surface: it comes back to itself after the whole knot.
            const double about = 2 * full_turn * turn;
            const glm::dvec3 ring(size * std::cos(about), size * std::sin(about), 0);
            const glm::dvec3 up = glm::normalize(centre - ring - glm::dot(centre - ring, tangent) * tangent);
            const glm::dvec3 side = glm::cross(tangent, up);
            const glm::dvec2 angle = cos_sin(row % around, around);
            const glm::dvec3 normal = angle.x * up + angle.y * side;
            knot.positions.emplace_back(centre + double(tube) * normal);
            knot.normals.emplace_back(normal);
            knot.texcoords[0].emplace_back(repeats * column / along, double(row) / around);
        }
    add_grid_indices(knot, along, around);
    return knot;
}

Primitive make_turned(std::span<const glm::dvec2> profile, uint32_t slices) {
    const size_t pieces = profile.size() - 1;
    std::vector<glm::dvec2> normals; // of each piece: radius, height
    for (size_t i = 0; i < pieces; ++i) {
        const glm::dvec2 along = profile[i + 1] - profile[i];
        normals.push_back(glm::normalize(glm::dvec2(-along.y, along.x)));
    }
    // A bend of more than a third of a right angle is an edge.
    const auto shared = [&](size_t piece, size_t neighbour) {
        const bool round = neighbour < pieces && glm::dot(normals[piece], normals[neighbour]) > 0.866;
        return round ? glm::normalize(normals[piece] + normals[neighbour]) : normals[piece];
    };
    Primitive turned;
    for (size_t i = 0; i < pieces; ++i) {
        const auto first = static_cast<uint32_t>(turned.positions.size());
        for (const size_t end : {i, i + 1}) {
            const glm::dvec2 at = profile[end], normal = shared(i, end == i ? i - 1 : i + 1);
            for (uint32_t column = 0; column <= slices; ++column) {
                const glm::dvec2 around = cos_sin(column, slices);
                turned.positions.emplace_back(at.x * around.x, at.y, -at.x * around.y);
                turned.normals.emplace_back(normal.x * around.x, normal.y, -normal.x * around.y);
            }
        }
        add_grid_indices(turned, slices, 1, first);
    }
    return turned;
}

Primitive make_box(glm::vec3 low, glm::vec3 high) {
    // Each face: the normal's axis, then two axes right and up with right × up = normal.
    struct Face {
        glm::vec3 normal{0}, right{0}, up{0};
    };
    constexpr std::array<Face, 6> faces{{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                         {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                         {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
                                         {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                         {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                         {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}}};
    Primitive box;
    for (const Face& face : faces) {
        const auto first = static_cast<uint32_t>(box.positions.size());
        for (const glm::vec2& corner : {glm::vec2{-1, 1}, {-1, -1}, {1, -1}, {1, 1}}) {
            const glm::vec3 side = face.normal + corner.x * face.right + corner.y * face.up;
            box.positions.emplace_back(side.x > 0 ? high.x : low.x, side.y > 0 ? high.y : low.y,
                                       side.z > 0 ? high.z : low.z);
            box.normals.push_back(face.normal);
            box.texcoords[0].emplace_back(corner.x > 0 ? 1 : 0, corner.y > 0 ? 0 : 1);
        }
        for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
            box.indices.push_back(first + corner);
    }
    return box;
}

Primitive make_ground(glm::vec2 size, uint32_t quads) {
    Primitive ground;
    for (uint32_t row = 0; row <= quads; ++row)
        for (uint32_t column = 0; column <= quads; ++column) {
            const glm::dvec2 at(static_cast<double>(column) / quads, static_cast<double>(row) / quads);
            ground.positions.emplace_back((at.x - 0.5) * size.x, 0, (at.y - 0.5) * size.y);
            ground.normals.emplace_back(0, 1, 0);
            ground.texcoords[0].emplace_back(at);
        }
    add_grid_indices(ground, quads, quads);
    return ground;
}

} // namespace prelight
