#include <array>
#include <cmath>
#include <numbers>
#include <scene/procedural/city_mesh.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

glm::vec2 circle(uint32_t k, uint32_t n) {
    const double angle = 2 * std::numbers::pi * (k % n) / n;
    return {std::cos(angle), std::sin(angle)};
}

/// Any unit vector perpendicular to the unit vector `axis`.
glm::vec3 perpendicular(glm::vec3 axis) {
    const glm::vec3 helper = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    return glm::normalize(glm::cross(helper, axis));
}

} // namespace

MeshBuilder& MeshBuilder::use(Surface new_surface, glm::vec3 new_tint) {
    surface = new_surface;
    tint = new_tint;
    return *this;
}

MeshBuilder& MeshBuilder::use(Glow colour) {
    palette = palette_uv(colour);
    return use(Surface::glow);
}

Primitive& MeshBuilder::primitive() {
    if (primitives.empty())
        primitives.resize(static_cast<size_t>(Surface::count));
    return primitives[static_cast<size_t>(surface)];
}

uint32_t MeshBuilder::vertex(Primitive& p, glm::vec3 local, glm::vec3 normal, glm::vec3 u_axis, glm::vec2 uv) {
    const auto index = static_cast<uint32_t>(p.positions.size());
    const glm::vec3 n = glm::normalize(frame.vector(normal));
    p.positions.push_back(frame.point(local));
    p.normals.push_back(n);
    p.colours.emplace_back(tint, 1);
    if (tile_metres(surface) > 0)
        p.texcoords[0].push_back(surface == Surface::glow ? palette : uv);
    if (has_normal_map(surface)) {
        const glm::vec3 t = frame.vector(u_axis);
        p.tangents.emplace_back(glm::normalize(t - n * glm::dot(n, t)), 1);
    }
    return index;
}

glm::vec2 MeshBuilder::planar(glm::vec3 local, glm::vec3 u_axis, glm::vec3 v_axis) const {
    // The image's v runs down, the surface's v axis up.
    return glm::vec2(glm::dot(local, u_axis), -glm::dot(local, v_axis)) / std::max(tile_metres(surface), 1e-3f);
}

void MeshBuilder::quad(glm::vec3 o, glm::vec3 u, glm::vec3 v) {
    const glm::vec3 n = glm::normalize(glm::cross(u, v));
    const glm::vec3 u_axis = glm::normalize(u), v_axis = glm::cross(n, u_axis);
    Primitive& p = primitive();
    std::array<uint32_t, 4> corner{};
    for (uint32_t i = 0; i < 4; ++i) {
        const glm::vec3 at = o + (i == 1 || i == 2 ? u : glm::vec3(0)) + (i >= 2 ? v : glm::vec3(0));
        corner[i] = vertex(p, at, n, u_axis, planar(at, u_axis, v_axis));
    }
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
        p.indices.push_back(corner[i]);
}

void MeshBuilder::quad(glm::vec3 o, glm::vec3 u, glm::vec3 v, const TexRect& rect) {
    quad(o, u, v);
    Primitive& p = primitive();
    const size_t first = p.texcoords[0].size() - 4;
    const glm::vec2 a = rect.lower_left, b = rect.upper_right;
    p.texcoords[0][first] = a;
    p.texcoords[0][first + 1] = {b.x, a.y};
    p.texcoords[0][first + 2] = b;
    p.texcoords[0][first + 3] = {a.x, b.y};
}

void MeshBuilder::box(glm::vec3 low, glm::vec3 high, unsigned faces) {
    const glm::vec3 e = high - low;
    const glm::vec3 s(e.x, 0, 0), y(0, e.y, 0), d(0, 0, e.z);
    if (faces & front)
        quad({low.x, low.y, high.z}, s, y);
    if (faces & back)
        quad({high.x, low.y, low.z}, -s, y);
    if (faces & right)
        quad(glm::vec3(high.x, low.y, high.z), -d, y);
    if (faces & left)
        quad(low, d, y);
    if (faces & top)
        quad({low.x, high.y, high.z}, s, -d);
    if (faces & bottom)
        quad(low, s, d);
}

void MeshBuilder::cone(glm::vec3 from, glm::vec3 to, float radius_from, float radius_to, uint32_t sides, bool caps) {
    const glm::vec3 axis = glm::normalize(to - from);
    const glm::vec3 a = perpendicular(axis), b = glm::cross(axis, a);
    const float slope = (radius_from - radius_to) / glm::length(to - from);
    Primitive& p = primitive();
    const auto first = static_cast<uint32_t>(p.positions.size());
    const float metres = 2 * std::numbers::pi_v<float> * std::max(radius_from, radius_to);
    const float tile = std::max(tile_metres(surface), 1e-3f);
    for (uint32_t i = 0; i <= sides; ++i) {
        const glm::vec2 c = circle(i, sides);
        const glm::vec3 out = c.x * a + c.y * b;
        const glm::vec3 n = glm::normalize(out + slope * axis);
        const glm::vec3 along = c.x * b - c.y * a;
        const float u = metres / tile * static_cast<float>(i) / static_cast<float>(sides);
        vertex(p, from + radius_from * out, n, along, {u, 0});
        vertex(p, to + radius_to * out, n, along, {u, -glm::length(to - from) / tile});
    }
    for (uint32_t i = 0; i < sides; ++i) {
        const uint32_t k = first + 2 * i;
        if (radius_from > 0)
            p.indices.insert(p.indices.end(), {k, k + 2, k + 1});
        if (radius_to > 0)
            p.indices.insert(p.indices.end(), {k + 2, k + 3, k + 1});
    }
    if (!caps)
        return;
    std::vector<glm::vec3> start, end;
    for (uint32_t i = 0; i < sides; ++i) {
        const glm::vec2 c = circle(i, sides), m = circle(sides - i, sides);
        end.push_back(to + radius_to * (c.x * a + c.y * b));
        start.push_back(from + radius_from * (m.x * a + m.y * b));
    }
    if (radius_from > 0)
        polygon(start);
    if (radius_to > 0)
        polygon(end);
}

void MeshBuilder::tube(std::span<const glm::vec3> points, float radius, uint32_t sides) {
    for (size_t i = 0; i + 1 < points.size(); ++i)
        cone(points[i], points[i + 1], radius, radius, sides);
}

void MeshBuilder::sphere(glm::vec3 centre, glm::vec3 radii, uint32_t slices, uint32_t stacks) {
    Primitive& p = primitive();
    const auto first = static_cast<uint32_t>(p.positions.size());
    for (uint32_t row = 0; row <= stacks; ++row)
        for (uint32_t column = 0; column <= slices; ++column) {
            const glm::vec2 polar = circle(row, 2 * stacks), around = circle(column, slices);
            const float ring = row == 0 || row == stacks ? 0 : polar.y;
            const glm::vec3 unit(ring * around.x, polar.x, -ring * around.y);
            const float u = static_cast<float>(column) / static_cast<float>(slices);
            const float v = static_cast<float>(row) / static_cast<float>(stacks);
            vertex(p, centre + radii * unit, glm::normalize(unit / radii), {-around.y, 0, -around.x}, {u, v});
        }
    for (uint32_t row = 0; row < stacks; ++row)
        for (uint32_t column = 0; column < slices; ++column) {
            const uint32_t a = first + row * (slices + 1) + column, b = a + slices + 1;
            if (row + 1 < stacks)
                p.indices.insert(p.indices.end(), {a, b, b + 1});
            if (row > 0)
                p.indices.insert(p.indices.end(), {a, b + 1, a + 1});
        }
}

void MeshBuilder::gem(glm::vec3 centre, float radius) {
    const glm::vec3 x(radius, 0, 0), y(0, radius, 0), z(0, 0, radius);
    const std::array<glm::vec3, 4> ring{x, -z, -x, z};
    for (size_t i = 0; i < 4; ++i) {
        const glm::vec3 a = centre + ring[i], b = centre + ring[(i + 1) % 4];
        polygon(std::array{a, b, centre + y});
        polygon(std::array{b, a, centre - y});
    }
}

void MeshBuilder::patch(std::span<const glm::vec3> points, uint32_t columns) {
    const auto rows = static_cast<uint32_t>(points.size() / columns);
    const auto at = [&](uint32_t row, uint32_t column) { return points[row * columns + column]; };
    Primitive& p = primitive();
    const auto first = static_cast<uint32_t>(p.positions.size());
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t c0 = column > 0 ? column - 1 : 0, c1 = std::min(column + 1, columns - 1);
            const uint32_t r0 = row > 0 ? row - 1 : 0, r1 = std::min(row + 1, rows - 1);
            const glm::vec3 along = at(row, c1) - at(row, c0), down = at(r1, column) - at(r0, column);
            vertex(p, at(row, column), glm::normalize(glm::cross(along, down)), glm::normalize(along),
                   planar(at(row, column), {1, 0, 0}, {0, 0, -1}));
        }
    for (uint32_t row = 0; row + 1 < rows; ++row)
        for (uint32_t column = 0; column + 1 < columns; ++column) {
            const uint32_t a = first + row * columns + column, b = a + columns;
            p.indices.insert(p.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
}

void MeshBuilder::polygon(std::span<const glm::vec3> points) {
    const glm::vec3 n = glm::normalize(glm::cross(points[1] - points[0], points[2] - points[0]));
    const glm::vec3 u_axis = glm::normalize(points[1] - points[0]), v_axis = glm::cross(n, u_axis);
    Primitive& p = primitive();
    const auto first = static_cast<uint32_t>(p.positions.size());
    for (const glm::vec3& point : points)
        vertex(p, point, n, u_axis, planar(point, u_axis, v_axis));
    for (uint32_t i = 1; i + 1 < points.size(); ++i)
        p.indices.insert(p.indices.end(), {first, first + i, first + i + 1});
}

Mesh MeshBuilder::finish(std::string name, glm::vec3 origin) {
    Mesh mesh{.name = std::move(name), .primitives = {}};
    for (size_t i = 0; i < primitives.size(); ++i) {
        Primitive& p = primitives[i];
        if (p.indices.empty())
            continue;
        p.material = static_cast<uint32_t>(i);
        for (glm::vec3& position : p.positions)
            position -= origin;
        bool white = true;
        for (const glm::vec4& colour : p.colours)
            white = white && colour == glm::vec4(1);
        if (white)
            p.colours.clear();
        mesh.primitives.push_back(std::move(p));
    }
    primitives.clear();
    return mesh;
}

} // namespace prelight::city
