#include <glm/geometric.hpp>
#include <scene/tangents.hpp>

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

} // namespace

void make_flat_normals(Primitive& primitive) {
    unshare(primitive.positions, primitive.indices);
    unshare(primitive.colours, primitive.indices);
    for (auto& set : primitive.texcoords)
        unshare(set, primitive.indices);
    primitive.tangents.clear();
    primitive.normals.clear();
    primitive.normals.reserve(primitive.positions.size());
    const auto& p = primitive.positions;
    for (size_t i = 0; i + 2 < p.size(); i += 3)
        primitive.normals.insert(primitive.normals.end(), 3, face_normal(p[i], p[i + 1], p[i + 2]));
    for (size_t i = 0; i < primitive.indices.size(); ++i)
        primitive.indices[i] = static_cast<uint32_t>(i);
}

} // namespace prelight
