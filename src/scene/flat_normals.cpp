#include <glm/geometric.hpp>
#include <scene/tangents.hpp>
#include <scene/vertex_lists.hpp>

namespace prelight {
namespace {

/// One element per index: each triangle corner gets a vertex of its own.
template <typename T>
void unshare(std::vector<T>& attribute, const std::vector<uint32_t>& indices) {
    if (attribute.empty())
        return;
    std::vector<T> corners;
    corners.reserve(indices.size());
    for (const uint32_t index : indices)
        corners.push_back(attribute[index]);
    attribute = std::move(corners);
}

/// In double precision, so that small triangles far from the origin keep their direction.
glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 origin(a);
    const glm::dvec3 cross = glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin);
    const double length = glm::length(cross);
    // A triangle without area covers no pixel; any unit vector keeps the normals' contract.
    return length > 0 ? glm::vec3(cross / length) : glm::vec3(0, 0, 1);
}

void set_face_normals(Primitive& primitive) {
    const auto& p = primitive.positions;
    for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const uint32_t* corner = &primitive.indices[i];
        const glm::vec3 normal = face_normal(p[corner[0]], p[corner[1]], p[corner[2]]);
        for (int c = 0; c < 3; ++c)
            primitive.normals[corner[c]] = normal;
    }
}

} // namespace

void make_flat_normals(Primitive& primitive) {
    primitive.tangents.clear();
    primitive.normals.clear();
    for_vertex_lists(primitive, [&](auto& list) { unshare(list, primitive.indices); });
    for (size_t i = 0; i < primitive.indices.size(); ++i)
        primitive.indices[i] = static_cast<uint32_t>(i);
    primitive.flat_normals = true;
    primitive.normals.resize(primitive.positions.size());
    set_face_normals(primitive);
}

void turn_flat_normals(Primitive& primitive) {
    set_face_normals(primitive);
    for (size_t v = 0; v < primitive.tangents.size(); ++v) {
        const glm::dvec3 normal(primitive.normals[v]), tangent(primitive.tangents[v]);
        const glm::dvec3 inside = tangent - glm::dot(normal, tangent) * normal;
        if (glm::length(inside) > 1e-6)
            primitive.tangents[v] = glm::vec4(glm::normalize(inside), primitive.tangents[v].w);
    }
}

} // namespace prelight
