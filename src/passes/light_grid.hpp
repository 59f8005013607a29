#pragma once
#include <prelight/scene.hpp>
#include <resident/gpu_scene.hpp>
#include <span>

namespace prelight::passes {

/// What a grid lies over: the world, or what is drawn over the opaque picture, which may be a small part of it.
enum class GridOver { world, layers };
resident::WorldBox box_of(GridOver over, const resident::GpuScene& scene);

/// A uniform grid over a box of the world; no cells: none.
struct LightGrid {
    GridOver over = GridOver::world;
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
