#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <scene/tangents.hpp>
#include <scene/tangents_groups.hpp>
#include <scene/vertex_lists.hpp>
#include <tuple>

namespace prelight {
namespace {

using namespace tangents;

/// Above this many faces the members of a group are no longer compared one with another: the work
/// grows with the square, and a hostile file could make one fan of millions.
constexpr size_t max_compared = 256;

/// The part of v in the plane with normal n, made a unit vector.
glm::vec3 in_plane(const glm::vec3& v, const glm::vec3& n) { return unit_or_zero(v - glm::dot(n, v) * n); }

/// Tangent of some faces around a vertex: their directions of growing u in the vertex's plane,
/// weighted with the corner's angle in that plane (Mikkelsen 2008, section 3.3).
glm::vec3 average(std::span<const uint32_t> members, uint32_t vertex, const std::vector<Face>& faces,
                  const Vertices& vertices) {
    const glm::vec3& n = vertices.normals[vertex];
    const glm::vec3& origin = vertices.positions[vertex];
    glm::vec3 sum(0);
    for (const uint32_t index : members) {
        const Face& face = faces[index];
        if (face.with_any)
            continue;
        const uint32_t corner = corner_at(face, vertex);
        const auto edge = [&](uint32_t to) {
            return in_plane(vertices.positions[face.corners[(corner + to) % 3]] - origin, n);
        };
        const float cosine = std::clamp(glm::dot(edge(2), edge(1)), -1.0f, 1.0f);
        sum += static_cast<float>(std::acos(static_cast<double>(cosine))) * in_plane(face.s, n);
    }
    return unit_or_zero(sum);
}

/// Tangents of a group's faces, in the order of group.faces. A member averages over those of the
/// others that do not point exactly the opposite way (MikkTSpace's angular threshold of 180°);
/// faces without texture area go with all.
std::vector<glm::vec3> group_tangents(const Group& group, const std::vector<Face>& faces, const Vertices& vertices) {
    const size_t count = group.faces.size();
    const glm::vec3& n = vertices.normals[group.vertex];
    struct Frame {
        glm::vec3 s{0}, t{0};
        bool with_any;
    };
    std::vector<Frame> frames;
    for (const uint32_t index : group.faces)
        frames.push_back({in_plane(faces[index].s, n), in_plane(faces[index].t, n), faces[index].with_any});
    const auto together = [](const Frame& a, const Frame& b, float threshold) {
        return a.with_any || b.with_any || (glm::dot(a.s, b.s) > threshold && glm::dot(a.t, b.t) > threshold);
    };
    const auto apart = [&](const Frame& a, const Frame& b) { return &a != &b && !together(a, b, -1.0f); };
    // Directions that all lie well within 90° of one cannot oppose each other: the common case.
    const Frame& first =
        *std::find_if(frames.begin(), frames.end(), [](const Frame& frame) { return !frame.with_any; });
    const bool close =
        std::all_of(frames.begin(), frames.end(), [&](const Frame& frame) { return together(first, frame, 0.01f); });
    const glm::vec3 whole = average(group.faces, group.vertex, faces, vertices);
    std::vector<glm::vec3> result(count, whole);
    if (close || count > max_compared)
        return result;
    std::vector<uint32_t> members;
    for (size_t i = 0; i < count; ++i) {
        members.clear();
        for (size_t j = 0; j < count; ++j)
            if (!apart(frames[i], frames[j]))
                members.push_back(group.faces[j]);
        if (members.size() != count)
            result[i] = average(members, group.vertex, faces, vertices);
    }
    return result;
}

/// Opposed directions can cancel, and a normal can be no number: the contract is a unit vector.
glm::vec3 make_sound(const glm::vec3& tangent, const glm::vec3& normal) {
    const float length = glm::length(tangent);
    if (std::abs(length - 1) < 1e-3f)
        return tangent;
    const glm::vec3 axis = std::abs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 across = axis - glm::dot(normal, axis) * normal;
    const float across_length = glm::length(across);
    return across_length > 0.1f ? across / across_length : glm::vec3(1, 0, 0);
}

/// One tangent for each index of the list.
std::vector<glm::vec4> corner_tangents(const Vertices& vertices, std::span<const uint32_t> indices) {
    const std::vector<uint32_t> welded = weld(vertices);
    std::vector<Face> faces = make_faces(vertices, indices, welded);
    const Groups grouped = build_groups(faces);
    // In MikkTSpace's own sense a corner without a group has sign −1.
    std::vector<glm::vec4> corners(indices.size(), {1, 0, 0, 1});
    std::vector<bool> regular(indices.size(), false);
    for (const Group& group : grouped.groups) {
        const auto values = group_tangents(group, faces, vertices);
        for (size_t i = 0; i < values.size(); ++i) {
            const Face& face = faces[group.faces[i]];
            const size_t corner = 3 * size_t(face.triangle) + corner_at(face, group.vertex);
            corners[corner] = {make_sound(values[i], vertices.normals[group.vertex]), group.preserving ? -1.0f : 1.0f};
        }
    }
    // Corners of triangles without area take what the first regular triangle has at that vertex.
    std::vector<uint32_t> first_user(vertices.positions.size(), none);
    for (const Face& face : faces)
        for (uint32_t corner = 0; corner < 3; ++corner) {
            const uint32_t at = 3 * face.triangle + corner;
            regular[at] = true;
            if (first_user[face.corners[corner]] == none)
                first_user[face.corners[corner]] = at;
        }
    for (size_t i = 0; i < indices.size(); ++i)
        if (const uint32_t user = first_user[welded[indices[i]]]; !regular[i] && user != none)
            corners[i] = corners[user];
    return corners;
}

/// Repeats vertex `index` at the end, but for its tangent.
void repeat_vertex(Primitive& primitive, uint32_t index) {
    for_vertex_lists(primitive, [index](auto& attribute) {
        if (attribute.empty())
            return;
        const auto value = attribute[index];
        attribute.push_back(value);
    });
}

/// Gives every corner a vertex with its tangent: corners sorted by vertex and tangent fall into
/// runs that share one; a vertex's first run keeps it, each further run gets a copy.
void assign(Primitive& primitive, const std::vector<glm::vec4>& corners) {
    const auto old = primitive.indices;
    const auto key = [&](uint32_t corner) {
        const glm::vec4& t = corners[corner];
        return std::tie(old[corner], t.x, t.y, t.z, t.w);
    };
    std::vector<uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
    primitive.tangents.assign(primitive.positions.size(), {1, 0, 0, 1});
    for (size_t i = 0; i < order.size(); ++i) {
        uint32_t& index = primitive.indices[order[i]];
        if (i == 0 || old[order[i]] != old[order[i - 1]]) {
            primitive.tangents[index] = corners[order[i]];
        } else if (key(order[i]) == key(order[i - 1])) {
            index = primitive.indices[order[i - 1]];
        } else {
            repeat_vertex(primitive, index);
            index = static_cast<uint32_t>(primitive.tangents.size());
            primitive.tangents.push_back(corners[order[i]]);
        }
    }
}

} // namespace

void generate_tangents(Primitive& primitive, uint32_t texcoord_set) {
    TextureRef plain;
    plain.texcoord = texcoord_set;
    generate_tangents(primitive, plain);
}

void generate_tangents(Primitive& primitive, const TextureRef& texture) {
    const std::vector<glm::vec2>* texcoords = &primitive.texcoords.at(texture.texcoord);
    assert(primitive.normals.size() == primitive.positions.size());
    assert(texcoords->size() == primitive.positions.size());
    std::vector<glm::vec2> transformed;
    if (texture.uv_linear != glm::mat2(1)) {
        transformed.reserve(texcoords->size());
        for (const glm::vec2& uv : *texcoords)
            transformed.push_back(texture.uv_linear * uv);
        texcoords = &transformed;
    }
    assign(primitive, corner_tangents({primitive.positions, primitive.normals, *texcoords}, primitive.indices));
}

} // namespace prelight
