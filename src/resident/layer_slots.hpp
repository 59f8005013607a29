#pragma once
#include "scene.hpp"
#include <shared/frame.h>
#include <vulkan/vulkan_core.h>

namespace prelight::resident {

/// Which texels of a picture's 2×2 blocks each blended draw may write, for layers that share a buffer of surfaces with
/// what is opaque (Kircher and Lawrance 2009): slot k has the texel with (x & 1) + 2 (y & 1) = k, and slot 0 is the
/// opaque surface's.
struct LayerSlots {
    std::vector<uint32_t> of; ///< by index into Geometry::draws: 1 … 3; 0: not blended, hidden, or not in the picture
    uint32_t drawn = 0;       ///< draws with a slot
    uint32_t without_own = 0; ///< of them, those that share theirs with a draw that they may cover
};

/// Draws whose rectangles on the screen meet get different slots, as far as three go round; where they do not, the
/// nearest surface wins, texel by texel. Each prefers a slot by its number among the world's blended draws, and takes
/// the next one that is free: so a slot depends on this frame alone, and changes only where rectangles begin or cease
/// to meet, and not when draws pass each other in depth. `extent`: of the picture.
void find_layer_slots(LayerSlots& out, const Geometry& geometry, const World& world,
                      const shared::FrameConstants& constants, glm::dvec3 eye, VkExtent2D extent);

} // namespace prelight::resident
