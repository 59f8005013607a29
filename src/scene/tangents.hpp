#pragma once
#include <cstdint>
#include <prelight/scene.hpp>

namespace prelight {

/// Tangents as MikkTSpace defines them (M. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited",
/// 2008, and its published algorithm "mikktspace" that bakers share), which glTF 2.0 asks for where
/// a file has none. Needs normals and texcoords[texcoord_set], as long as `positions`, and indices
/// below that length; earlier tangents are replaced. Vertices where tangents differ (mirrored
/// texture coordinates, seams) are split: one of them keeps the old place, the others are appended.
/// w has glTF's sense: texture coordinates run down, so the bitangent w · (N × T) points to smaller
/// v. Every tangent is finite and of unit length; where texture coordinates say nothing it is (1,
/// 0, 0).
void generate_tangents(Primitive& primitive, uint32_t texcoord_set);
/// The same for the coordinates that a texture really reads: its set, under its transform. Tangents turn
/// with the texture, and a mirrored one has the other sign; an offset changes neither.
void generate_tangents(Primitive& primitive, const TextureRef& texture);

/// Tangents that follow one texture serve the other too: the same set under the same linear map.
inline bool share_tangents(const TextureRef& a, const TextureRef& b) {
    return a.texcoord == b.texcoord && a.uv_linear == b.uv_linear;
}

/// Normals of the triangles themselves: every corner gets a vertex of its own (attributes are
/// repeated, indices become 0, 1, 2 …) and tangents are discarded, as glTF 2.0 asks. A triangle
/// without area gets (0, 0, 1). Sets Primitive::flat_normals.
void make_flat_normals(Primitive& primitive);

/// Normals of the triangles once more, after the vertices of a primitive that make_flat_normals() has
/// treated were moved. Tangents are turned into their triangles' planes.
void turn_flat_normals(Primitive& primitive);

} // namespace prelight
