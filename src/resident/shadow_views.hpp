#pragma once
#include "world_box.hpp"
#include <glm/mat4x4.hpp>
#include <prelight/scene.hpp>
#include <shared/shadow.h>
#include <vector>

namespace prelight::resident {

/// How a light looks at the world through one of its tiles: world relative to the world's centre → clip space
/// of the tile (reversed depth, the near plane at 1).
struct ShadowView {
    glm::dmat4 clip_from_centre{1};
    double texel = 0, texel_per_w = 0; ///< metres that a texel covers
    double depth_range = 0;            ///< metres from depth 0 to 1; 0: perspective
};

/// How many tiles a light has: SHADOW_SPOT 1, SHADOW_CASCADES 4, SHADOW_FACES 6.
uint32_t shadow_kind(const Light& light);
uint32_t shadow_tiles(const Light& light);

/// The view depths where a camera's four cascades end. They depend on the world's box and the camera's lens, and
/// not on where it looks, so that cascades do not change as it turns: between logarithmic and even steps
/// ("practical split scheme", Zhang and others 2006).
glm::dvec4 cascade_ends(const PlacedCamera& camera, const WorldBox& world);

/// Views of a light's tiles of `side` texels, `guard` of which on each edge lie outside of what the tile is asked
/// for: there the filter finds what it needs beyond the edge of a face or cascade.
///
/// Faces of a cube look along the world's axes. A cascade is a square around the sphere of its slice of the
/// camera's view, so that it does not change as the camera turns, and it moves in steps of whole texels.
void find_shadow_views(const PlacedLight& light, const PlacedCamera& camera, double aspect, const WorldBox& world,
                       uint32_t side, uint32_t guard, std::vector<ShadowView>& out);

} // namespace prelight::resident
