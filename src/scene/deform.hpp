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

struct Deformed {
    Mesh mesh;
    /// What vertices are relative to, world space; only with a skin, else 0. Kept in double, so that
    /// a mesh far from the world's origin loses nothing when its vertices become float.
    glm::dvec3 origin{0};
};

/// glTF 2.0, 3.7.2.2 and 3.7.3: morph targets first, then the skin, summed up in double. Normals
/// and tangents follow (by the inverse transpose; flat normals are made anew) and are unit vectors
/// again. Where the joints mirror, triangles are turned round, so that fronts stay fronts.
/// `previous`, when given, fills Primitive::previous_positions of what moved.
/// Throws Error "`object`: REASON" for a joint that is not there or a vertex that is not finite.
Deformed deform(const Mesh& mesh, const Shape& shape, const Shape* previous, const std::string& object);

} // namespace prelight
