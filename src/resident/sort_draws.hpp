#pragma once
#include "visible_draws.hpp"

namespace prelight::resident {

/// Draws that one call may show: same state, same triangles.
bool same_but_place(const Draw& a, const Draw& b);

/// Occluders first: draws that differ in nothing but their place stay together, front to back, and these runs follow
/// one another by their nearest draw. `draws` come in the order of `all`. `before`: VisibleDraws::place of the frame
/// before; it makes no difference but to the time that sorting takes, for most draws stand where they stood.
void sort_by_distance(std::vector<VisibleDraw>& draws, const std::vector<Draw>& all, const glm::dvec3& eye,
                      const glm::dvec3& forward, std::span<const uint32_t> before);

/// What is behind others first, by the middle of their bounds; at the same depth the last of the world first, so that
/// the first lies on top.
void sort_back_to_front(std::vector<VisibleDraw>& draws, const std::vector<Draw>& all, const glm::dvec3& eye,
                        const glm::dvec3& forward);

} // namespace prelight::resident
