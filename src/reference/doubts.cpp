#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <reference/doubts.hpp>
#include <reference/same_surface.hpp>

namespace prelight::reference {
namespace {

constexpr uint32_t nothing = 0xffffffffu;
constexpr double near = 1.0 / 128; ///< pixels

bool continues(const SeenSample& a, const SeenSample& b) {
    if (a.draw != b.draw)
        return false;
    return a.draw == nothing || a.triangle == b.triangle ||
           (same_plane(a.position, a.geometric_normal, a.depth, b.position) && same_direction(a.normal, b.normal));
}

/// Whether a ray this close to the sample's sees another surface.
bool turns(const SeenWorld& world, const Sample& sample, const Ray& ray) {
    Hit hit;
    if (world.rays().closest(ray, hit) != sample.found || hit.mask_outcome != sample.hit.mask_outcome)
        return true;
    if (!sample.found || (hit.draw == sample.hit.draw && hit.triangle == sample.hit.triangle))
        return false;
    return hit.draw != sample.hit.draw ||
           !same_plane(sample.hit.position, sample.hit.geometric_normal, sample.hit.distance, hit.position) ||
           !same_direction(world.normal(sample.hit, sample.ray), world.normal(hit, ray));
}

} // namespace

SeenSample remember(const SeenWorld& world, uint32_t x, uint32_t y, const Sample& sample) {
    SeenSample seen;
    seen.mask_outcome = sample.hit.mask_outcome;
    for (const glm::dvec2& aside :
         {glm::dvec2(near, 0), glm::dvec2(-near, 0), glm::dvec2(0, near), glm::dvec2(0, -near)})
        seen.near_edge = seen.near_edge || turns(world, sample, world.lens().ray(x, y, sample.place + aside));
    if (!sample.found)
        return seen;
    seen.draw = sample.hit.draw;
    seen.triangle = sample.hit.triangle;
    seen.lit = sample.lit;
    seen.runs_away = sample.runs_away;
    seen.unclear = sample.unclear;
    seen.shadow_unclear = sample.shadow_unclear;
    seen.position = glm::vec3(sample.hit.position);
    seen.normal = glm::vec3(sample.surface.normal);
    seen.geometric_normal = glm::vec3(sample.hit.geometric_normal);
    seen.depth = static_cast<float>(sample.hit.distance);
    seen.shadow_mask = sample.shadow_mask;
    return seen;
}

void find_doubts(ReferencePicture& picture, std::span<const SeenSample> seen, uint32_t row) {
    using Picture = ReferencePicture;
    const uint32_t width = picture.linear.width, height = picture.linear.height, count = picture.samples;
    const auto of = [&](uint32_t x, uint32_t y) { return seen.subspan((size_t(y) * width + x) * count, count); };
    for (uint32_t x = 0; x < width; ++x) {
        const std::span<const SeenSample> own = of(x, row);
        uint8_t doubts = 0, edge = 0;
        for (const SeenSample& a : own) {
            doubts |= (a.near_edge ? Picture::near_edge : 0) | (a.runs_away ? Picture::extrapolated : 0) |
                      (a.unclear ? Picture::sharing : 0) | (a.shadow_unclear ? Picture::shadow : 0);
            for (const SeenSample& b : own)
                edge |= continues(a, b) ? 0 : 1;
            for (uint32_t v = row - (row > 0); v <= std::min(row + 1, height - 1); ++v)
                for (uint32_t u = x - (x > 0); u <= std::min(x + 1, width - 1); ++u)
                    for (const SeenSample& b : of(u, v)) {
                        if (a.mask_outcome != b.mask_outcome)
                            doubts |= Picture::mask;
                        if (a.shadow_mask != b.shadow_mask && a.lit && b.lit && continues(a, b))
                            doubts |= Picture::shadow;
                    }
        }
        picture.edge[size_t(row) * width + x] = edge;
        picture.doubts[size_t(row) * width + x] = doubts;
    }
}

} // namespace prelight::reference
