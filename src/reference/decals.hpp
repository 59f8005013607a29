#pragma once
#include <reference/surface.hpp>

namespace prelight::reference {

/// The world's decals (prelight/decal.hpp), relative to `origin`.
class Decals {
public:
    Decals(const World& world, glm::dvec3 origin, const Textures& textures);
    /// Lays on the surface whatever decals hold its point, the lowest first. What lights see of its roughness is to be
    /// found anew: set_lamp_roughness().
    void cover(Surface& surface) const;

private:
    struct Box {
        const Decal* decal;
        const Material* material;
        glm::dvec3 centre{0}, sides[3]{}; ///< relative to the origin; the box's edges as vectors
    };
    const Textures& textures_;
    std::vector<Box> boxes_;
};

} // namespace prelight::reference
