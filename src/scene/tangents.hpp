#pragma once
#include <cstdint>
#include <prelight/scene.hpp>

namespace prelight {

/// MikkTSpace tangents; may unshare vertices. Needs normals and texcoords[set].
void generate_tangents(Primitive& primitive, uint32_t texcoord_set);
/// Flat normals: unshares every vertex, discards tangents.
void make_flat_normals(Primitive& primitive);

} // namespace prelight
