#pragma once
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <prelight/glm_defaults.hpp>

namespace prelight {

/// A material that lies on whatever is inside of a box: the unit cube around its node's origin, sides −½ … ½.
/// The picture is seen by somebody who looks along the node's −Z axis: its right is +X, its top +Y. So a
/// decal on a floor has its +Z upwards.
///
/// Of a surface point in the box, with c = base colour's alpha (factor × texture) × opacity × fade:
/// base colour and metallic become mix(surface's, decal's, c), so does roughness; the normal becomes
/// normalize(mix(n, m, c)), where m is the normal map's vector in the frame of n and the box's X and Y axes.
/// Where decals overlap, the later one is mixed over the earlier; each m stands on the surface's own n.
struct Decal {
    uint32_t material = 0; ///< index into Scene::materials, one without a shader of its own
    float opacity = 1;     ///< 0 … 1
    int32_t order = 0;     ///< higher ones lie over lower ones; among equals the later node
    /// Angle between the surface's normal and the box's +Z, radians, 0 ≤ from ≤ to ≤ π/2: whole up to the first,
    /// gone from the second on, smoothstep of the cosine between them.
    float fade_from = 1.04719755f;
    float fade_to = 1.39626340f; ///< see fade_from
    bool colour = true;          ///< changes base colour and metallic
    bool normal = true;          ///< changes the normal, where the material has a normal map
    bool roughness = true;       ///< changes roughness
    /// Member by member.
    bool operator==(const Decal&) const = default;
};

/// A decal at its place in the world.
struct PlacedDecal {
    Decal decal;             ///< what lies there
    glm::dmat4 transform{1}; ///< box → world; can be inverted
};

} // namespace prelight
