#include "light_grid.hpp"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace prelight::passes {

LightGrid light_grid(std::span<const resident::Draw> draws, uint32_t most_cells) {
    LightGrid grid;
    grid.cells = glm::uvec3(1);
    if (draws.empty())
        return grid;
    glm::dvec3 low = draws[0].low, high = draws[0].high;
    for (const resident::Draw& draw : draws) {
        low = glm::min(low, draw.low);
        high = glm::max(high, draw.high);
    }
    // A little around everything, so that rounding leaves no surface outside and no axis is empty.
    const double longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-3});
    low -= 1e-4 * longest;
    high += 1e-4 * longest;
    const auto count = [&](double edge) { return glm::max(glm::ceil((high - low) / edge), glm::dvec3(1)); };
    double edge = longest / 128;
    for (glm::dvec3 n = count(edge); n.x * n.y * n.z > most_cells; n = count(edge))
        edge *= 1.05;
    grid.cells = glm::uvec3(count(edge));
    grid.low = low;
    grid.cell = (high - low) / glm::dvec3(grid.cells);
    return grid;
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
