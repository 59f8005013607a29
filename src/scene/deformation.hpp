#pragma once
#include <scene/deform.hpp>
#include <scene/mesh_facts.hpp>
#include <utility>

namespace prelight {

/// A box around the mesh in this shape: as large as joints and morph targets can make it, not as they do. World space
/// with a skin, else object space.
Bounds box_around(const MeshFacts& facts, const Shape& shape);

/// The shape, and the one before it, with vertices relative to a place: the middle of box_around() with a skin, else 0.
std::pair<Deformation, glm::dvec3> describe(const Mesh& mesh, uint32_t index, const MeshFacts& facts,
                                            const Shape& shape, const Shape& previous);

} // namespace prelight
