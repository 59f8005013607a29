#pragma once
#include "garden.hpp"

namespace prelight {

/// The garden with decals on its floor and spheres: colour, coverage, normals and metallic-roughness from textures,
/// overlapping, turned, mirrored, some channels only.
struct DecalGarden : Garden {
    explicit DecalGarden(glm::dvec3 origin = glm::dvec3(0));
    /// Box around `centre`, its +Z along `out`, turned by `turn` about it.
    PlacedDecal& add_decal(const Decal& decal, glm::dvec3 centre, glm::dvec3 out, double turn, glm::dvec3 size);
    uint32_t painted = 0, bumpy = 0, dull = 0; ///< materials for decals
};

} // namespace prelight
