#pragma once
#include <prelight/scene.hpp>
#include <resident/world_box.hpp>
#include <span>

namespace prelight::passes {

/// A uniform grid over the world's bounds; no cells: none.
struct LightGrid {
    glm::dvec3 low{0};  ///< world space
    glm::dvec3 cell{1}; ///< size of a cell, metres
    glm::uvec3 cells{0};
};

/// Cells as nearly cubic as can be, at most `most_cells`; flat worlds get few layers.
LightGrid light_grid(const resident::WorldBox& box, uint32_t most_cells = 32768);
/// The same number of cells over another box.
void stretch(LightGrid& grid, const resident::WorldBox& box);

/// How many cells all lights reach together, roughly and rather too many.
double grid_overlap(const LightGrid& grid, std::span<const PlacedLight> lights);

} // namespace prelight::passes
