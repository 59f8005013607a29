#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <scene/tangents_faces.hpp>
#include <tuple>

// Single precision throughout, in the published order of operations: tangent spaces are meant to be
// the same in every program down to which degenerate triangle counts as one.
namespace prelight::tangents {
namespace {

using Key = std::array<uint32_t, 8>;

Key key_of(const Vertices& vertices, uint32_t i) {
    const glm::vec3& p = vertices.positions[i];
    const glm::vec3& n = vertices.normals[i];
    const glm::vec2& uv = vertices.texcoords[i];
    const auto bits = [](float x) { return std::bit_cast<uint32_t>(x + 0.0f); }; // −0 + 0 = 0
    return {bits(p.x), bits(p.y), bits(p.z), bits(n.x), bits(n.y), bits(n.z), bits(uv.x), bits(uv.y)};
}

/// Solves for the directions of growing u and v (Mikkelsen 2008, section 3.1).
void set_frame(Face& face, const Vertices& vertices) {
    const auto [a, b, c] = face.corners;
    const glm::vec3 d1 = vertices.positions[b] - vertices.positions[a];
    const glm::vec3 d2 = vertices.positions[c] - vertices.positions[a];
    const glm::vec2 uv1 = vertices.texcoords[b] - vertices.texcoords[a];
    const glm::vec2 uv2 = vertices.texcoords[c] - vertices.texcoords[a];
    const float area = uv1.x * uv2.y - uv1.y * uv2.x;
    face.preserving = area > 0;
    if (!not_zero(area))
        return;
    const glm::vec3 s = uv2.y * d1 - uv1.y * d2;
    const glm::vec3 t = -uv2.x * d1 + uv1.x * d2;
    const float sign = face.preserving ? 1.0f : -1.0f;
    const float s_length = glm::length(s);
    const float t_length = glm::length(t);
    face.s = not_zero(s_length) ? sign / s_length * s : s;
    face.t = not_zero(t_length) ? sign / t_length * t : t;
    face.with_any = !not_zero(s_length / std::abs(area)) || !not_zero(t_length / std::abs(area));
}

/// One side of an edge; `low` < `high` are its two corners.
struct HalfEdge {
    uint32_t low, high, face;
    uint8_t edge;
    bool rising; ///< runs from low to high
    auto key() const { return std::tie(low, high, face); }
};

std::vector<HalfEdge> sorted_edges(std::span<const Face> faces) {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * faces.size());
    for (uint32_t f = 0; f < faces.size(); ++f)
        for (uint8_t edge = 0; edge < 3; ++edge) {
            const uint32_t from = faces[f].corners[edge];
            const uint32_t to = faces[f].corners[(edge + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), f, edge, from < to});
        }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) { return a.key() < b.key(); });
    return edges;
}

/// Pairs the half-edges of one edge: each with the earliest unpaired one of opposite direction.
void pair_up(std::span<const HalfEdge> edges, std::vector<Face>& faces, std::vector<HalfEdge>& waiting) {
    waiting.clear(); // all of one direction: an opposite one would have been paired
    size_t first = 0;
    for (const HalfEdge& edge : edges) {
        if (first == waiting.size() || waiting[first].rising == edge.rising) {
            waiting.push_back(edge);
            continue;
        }
        const HalfEdge& other = waiting[first++];
        faces[edge.face].neighbours[edge.edge] = other.face;
        faces[other.face].neighbours[other.edge] = edge.face;
    }
}

void find_neighbours(std::vector<Face>& faces) {
    const std::vector<HalfEdge> edges = sorted_edges(faces);
    std::vector<HalfEdge> waiting;
    for (size_t begin = 0; begin < edges.size();) {
        size_t end = begin + 1;
        while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high)
            ++end;
        pair_up(std::span(edges).subspan(begin, end - begin), faces, waiting);
        begin = end;
    }
}

} // namespace

bool not_zero(float x) { return std::abs(x) > FLT_MIN; }

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const bool zero = !not_zero(v.x) && !not_zero(v.y) && !not_zero(v.z);
    return zero ? v : 1.0f / glm::length(v) * v;
}

std::vector<uint32_t> weld(const Vertices& vertices) {
    const size_t count = vertices.positions.size();
    std::vector<Key> keys(count);
    std::vector<uint32_t> order(count), welded(count);
    std::iota(order.begin(), order.end(), 0u);
    for (uint32_t i = 0; i < count; ++i)
        keys[i] = key_of(vertices, i);
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return std::tie(keys[a], a) < std::tie(keys[b], b); });
    for (size_t i = 0; i < count; ++i) {
        const bool same = i > 0 && keys[order[i]] == keys[order[i - 1]];
        welded[order[i]] = same ? welded[order[i - 1]] : order[i];
    }
    return welded;
}

std::vector<Face> make_faces(const Vertices& vertices, std::span<const uint32_t> indices,
                             std::span<const uint32_t> welded) {
    std::vector<Face> faces;
    faces.reserve(indices.size() / 3);
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        Face face;
        for (size_t corner = 0; corner < 3; ++corner)
            face.corners[corner] = welded[indices[i + corner]];
        face.triangle = static_cast<uint32_t>(i / 3);
        const auto position = [&](size_t corner) { return vertices.positions[face.corners[corner]]; };
        if (position(0) == position(1) || position(1) == position(2) || position(2) == position(0))
            continue;
        set_frame(face, vertices);
        faces.push_back(face);
    }
    find_neighbours(faces);
    return faces;
}

} // namespace prelight::tangents
