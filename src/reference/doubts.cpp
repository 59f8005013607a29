#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <reference/doubts.hpp>
#include <reference/same_surface.hpp>

namespace prelight::reference {
namespace {

constexpr uint32_t nothing = 0xffffffffu;
constexpr double near = 1.0 / 128; ///< pixels

bool continues(const SeenSurface& a, const SeenSurface& b) {
    if (a.draw != b.draw)
        return false;
    return a.draw == nothing || a.triangle == b.triangle ||
           (same_plane(a.position, a.geometric_normal, a.depth, b.position) && same_direction(a.normal, b.normal));
}

/// Layer by layer too.
bool all_continue(const SeenSample& a, const SeenSample& b) {
    return continues(a.opaque, b.opaque) &&
           std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(), continues);
}

/// Whether one surface differs in shadows.
bool shadows_differ(const SeenSurface& a, const SeenSurface& b) {
    return a.shadow_mask != b.shadow_mask && a.lit && b.lit && continues(a, b);
}

/// Layers of two rays may differ in number: each is looked for among the other ray's.
bool shadows_differ(const SeenSample& a, const SeenSample& b) {
    return shadows_differ(a.opaque, b.opaque) || std::ranges::any_of(a.layers, [&](const SeenSurface& own) {
               return std::ranges::any_of(b.layers,
                                          [&](const SeenSurface& other) { return shadows_differ(own, other); });
           });
}

/// Whether two rays close to each other hit one surface there.
bool one_surface(const SeenWorld& world, const Hit& a, const Ray& ray_a, const Hit& b, const Ray& ray_b) {
    if (a.draw != b.draw || a.triangle == b.triangle)
        return a.draw == b.draw;
    return same_plane(a.position, a.geometric_normal, a.distance, b.position) &&
           same_direction(world.normal(a, ray_a), world.normal(b, ray_b));
}

/// Whether a ray through a place this close to the sample's sees another surface.
bool turns(const SeenWorld& world, uint32_t x, uint32_t y, const Sample& sample, glm::dvec2 place) {
    const Ray ray = world.lens().ray(x, y, place);
    Hit hit;
    std::vector<Hit> layers;
    bool found = world.rays().closest(ray, hit, &layers);
    leave_shown(world, sample.shows, x, y, place, found, hit, layers);
    if (found != sample.found || hit.mask_outcome != sample.hit.mask_outcome)
        return true;
    const auto same = [&](const Sample& own, const Hit& other) {
        return one_surface(world, own.hit, own.ray, other, ray);
    };
    return !std::equal(sample.layers.begin(), sample.layers.end(), layers.begin(), layers.end(), same) ||
           (sample.found && !same(sample, hit));
}

SeenSurface seen_surface(const Sample& sample) {
    SeenSurface seen;
    seen.draw = sample.hit.draw;
    seen.triangle = sample.hit.triangle;
    seen.lit = sample.lit;
    seen.position = glm::vec3(sample.hit.position);
    seen.normal = glm::vec3(sample.surface.normal);
    seen.geometric_normal = glm::vec3(sample.hit.geometric_normal);
    seen.depth = static_cast<float>(sample.hit.distance);
    seen.shadow_mask = sample.shadow_mask;
    return seen;
}

} // namespace

SeenSample remember(const SeenWorld& world, uint32_t x, uint32_t y, const Sample& sample) {
    SeenSample seen;
    seen.mask_outcome = sample.hit.mask_outcome;
    for (const glm::dvec2& aside :
         {glm::dvec2(near, 0), glm::dvec2(-near, 0), glm::dvec2(0, near), glm::dvec2(0, -near)})
        seen.near_edge = seen.near_edge || turns(world, x, y, sample, sample.place + aside);
    if (sample.found) {
        seen.opaque = seen_surface(sample);
        seen.runs_away = sample.runs_away;
        seen.unclear = sample.unclear;
        seen.shadow_unclear = sample.shadow_unclear;
    }
    for (const Sample& layer : sample.layers) {
        seen.layers.push_back(seen_surface(layer));
        seen.runs_away = seen.runs_away || layer.runs_away;
    }
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
                edge |= all_continue(a, b) ? 0 : 1;
            for (uint32_t v = row - (row > 0); v <= std::min(row + 1, height - 1); ++v)
                for (uint32_t u = x - (x > 0); u <= std::min(x + 1, width - 1); ++u)
                    for (const SeenSample& b : of(u, v)) {
                        if (a.mask_outcome != b.mask_outcome)
                            doubts |= Picture::mask;
                        if (shadows_differ(a, b))
                            doubts |= Picture::shadow;
                    }
        }
        picture.edge[size_t(row) * width + x] = edge;
        picture.doubts[size_t(row) * width + x] = doubts;
    }
}

} // namespace prelight::reference
