#pragma once
#include <prelight/scene.hpp>
#include <scene/gltf/attributes.hpp>

namespace prelight::gltf {

/// Triangles with a vertex that has no place are left out.
void drop_triangles_at(Primitive& primitive, const std::vector<uint32_t>& bad_places);

/// Unit length; where a normal is zero, the sum of the triangles around its vertex.
void unit_normals(const Item& item, Primitive& primitive);

/// JOINTS_n and WEIGHTS_n of every set. What is no weight is 0; sums other than 1 are told.
void read_joints(Document& document, const Item& item, Attributes& attributes, Primitive& primitive);

/// What JOINTS_n and WEIGHTS_n take of a vertex, in bytes.
inline constexpr uint64_t joint_set_bytes = 4 * 2 + 4 * 4;

} // namespace prelight::gltf
