#include "light_grid.hpp"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace prelight::passes {

namespace {

/// A little around everything, so that rounding leaves no surface outside and no axis is empty.
resident::WorldBox roomy(const resident::WorldBox& box) {
    const glm::dvec3 size = box.high - box.low;
    const double more = 1e-4 * std::max({size.x, size.y, size.z, 1e-3});
    return {box.low - more, box.high + more};
}

} // namespace

resident::WorldBox box_of(GridOver over, const resident::GpuScene& scene) {
    return over == GridOver::world ? scene.box() : resident::box_around_layers(scene.geometry().draws);
}

LightGrid light_grid(const resident::WorldBox& box, uint32_t most_cells) {
    const resident::WorldBox around = roomy(box);
    const auto count = [&](double edge) {
        return glm::max(glm::ceil((around.high - around.low) / edge), glm::dvec3(1));
    };
    const glm::dvec3 size = box.high - box.low;
    double edge = std::max({size.x, size.y, size.z, 1e-3}) / 128;
    for (glm::dvec3 n = count(edge); n.x * n.y * n.z > most_cells; n = count(edge))
        edge *= 1.05;
    LightGrid grid{.cells = glm::uvec3(count(edge))};
    stretch(grid, box);
    return grid;
}

void stretch(LightGrid& grid, const resident::WorldBox& box) {
    const auto [low, high] = roomy(box);
    grid.low = low;
    grid.cell = (high - low) / glm::dvec3(grid.cells);
}

double grid_overlap(const LightGrid& grid, std::span<const PlacedLight> lights) {
    double sum = 0;
    for (const PlacedLight& light : lights) {
        const glm::dvec3 across = 2.0 * double(light.light.range) / grid.cell + 1.0;
        const glm::dvec3 cells = glm::min(across, glm::dvec3(grid.cells));
        sum += std::isfinite(light.light.range) ? cells.x * cells.y * cells.z : 0;
    }
    return sum;
}

} // namespace prelight::passes
