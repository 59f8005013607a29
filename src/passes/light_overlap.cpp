#include "light_overlap.hpp"
#include "light_grid.hpp"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

namespace prelight::passes {
namespace {

/// How many boxes cover each cell of a grid: the corners of each box are marked, and sums along the three axes do the
/// rest, so that a box costs the same whatever its size.
class BoxCounts {
public:
    explicit BoxCounts(glm::uvec3 cells) : size_(cells + 1u), counts_(size_t(size_.x) * size_.y * size_.z) {}
    /// Cells from `low` to before `high`.
    void add(glm::uvec3 low, glm::uvec3 high) {
        for (uint32_t corner = 0; corner < 8; ++corner) {
            const bool x = corner & 1, y = corner & 2, z = corner & 4;
            counts_[index({x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z})] +=
                (x + y + z) % 2 == 0 ? 1 : -1;
        }
    }
    uint32_t most() {
        for (int axis = 0; axis < 3; ++axis) {
            glm::uvec3 step(0), at;
            step[axis] = 1;
            for (at.z = step.z; at.z < size_.z; ++at.z)
                for (at.y = step.y; at.y < size_.y; ++at.y)
                    for (at.x = step.x; at.x < size_.x; ++at.x)
                        counts_[index(at)] += counts_[index(at - step)];
        }
        return static_cast<uint32_t>(*std::max_element(counts_.begin(), counts_.end()));
    }

private:
    size_t index(glm::uvec3 at) const { return (size_t(at.z) * size_.y + at.y) * size_.x + at.x; }
    glm::uvec3 size_{0};
    std::vector<int32_t> counts_;
};

} // namespace

uint32_t light_overlap(std::span<const resident::Draw> draws, std::span<const PlacedLight> lights) {
    const LightGrid grid = light_grid(resident::box_around(draws));
    const glm::dvec3 cells(grid.cells);
    BoxCounts counts(grid.cells);
    uint32_t everywhere = 0;
    for (const PlacedLight& placed : lights) {
        const Light& light = placed.light;
        if (light.intensity <= 0)
            continue;
        if (light.kind == LightKind::directional || !std::isfinite(light.range)) {
            ++everywhere;
            continue;
        }
        // Shaders work in single precision: a little more than the range.
        const glm::dvec3 reach(double(light.range) * 1.001), centre = placed.position - grid.low;
        const glm::dvec3 low = glm::floor((centre - reach) / grid.cell),
                         high = glm::floor((centre + reach) / grid.cell) + 1.0;
        if (low.x >= cells.x || low.y >= cells.y || low.z >= cells.z || high.x <= 0 || high.y <= 0 || high.z <= 0)
            continue;
        counts.add(glm::uvec3(glm::max(low, glm::dvec3(0))), glm::uvec3(glm::min(high, cells)));
    }
    return everywhere + counts.most();
}

} // namespace prelight::passes
