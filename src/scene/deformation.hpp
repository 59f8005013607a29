#pragma once
#include <scene/deform.hpp>
#include <scene/mesh_facts.hpp>

namespace prelight {

/// A box around the mesh in this shape: as large as joints and morph targets can make it, not as they do. World space
/// with a skin, else object space.
Bounds box_around(const MeshFacts& facts, const Shape& shape);

/// The shape, and the one before it, with vertices relative to `origin` (0 without a skin).
Deformation describe(const Mesh& mesh, uint32_t index, const MeshFacts& facts, const Shape& shape,
                     const Shape& previous, const glm::dvec3& origin);

} // namespace prelight
