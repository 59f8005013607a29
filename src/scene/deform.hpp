#pragma once
#include <prelight/scene.hpp>
#include <span>

namespace prelight {

/// What shapes a mesh at one time.
struct Shape {
    std::vector<double> weights;          ///< of the morph targets; missing ones are 0
    std::span<const glm::dmat4> joints{}; ///< mesh space → world, by Skin::joints; empty: no skin
};

/// True where every primitive with triangles has joints to follow.
bool has_joints(const Mesh& mesh);
/// True where the shape leaves the mesh as the file stores it.
bool is_plain(const Mesh& mesh, const Shape& shape);

/// Additions of one vector that deform() does for the mesh: a bound of its time.
uint64_t deform_work(const Mesh& mesh);
uint64_t vertex_count(const Mesh& mesh);

/// Mesh → world of one vertex: the sum of its joints. Weights are made to sum up to exactly 1: what is left of a sum of
/// rounded ones would be millimetres 10 km from the origin.
glm::dmat4 joint_matrix(const Primitive& primitive, std::span<const glm::dmat4> joints, uint32_t vertex);

/// Throws Error "`object`: REASON" for a vertex that follows a joint which is not among `joints`.
void check_joints(const Mesh& mesh, size_t joints, const std::string& object);

/// glTF 2.0, 3.7.2.2 and 3.7.3: morph targets first, then the skin, summed up in double, relative to `origin`: a mesh
/// far from the world's origin loses nothing when its vertices become float. Normals and tangents follow (by the
/// inverse transpose; flat normals are made anew) and are unit vectors again. `turned`: the joints mirror
/// (Deformation::turned), and triangles are turned round, so that fronts stay fronts. `previous`, when given, fills
/// Primitive::previous_positions of what moved. Joints must have been checked. Throws Error "`object`: REASON" for a
/// vertex that is not finite.
Mesh deform(const Mesh& mesh, const Shape& shape, const Shape* previous, const glm::dvec3& origin, bool turned,
            const std::string& object);

} // namespace prelight
