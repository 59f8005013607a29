#include <algorithm>
#include <cmath>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/city.hpp>

namespace prelight {
namespace {

/// Where somebody welds or cuts: the place, the way the sparks fly, what they fall on.
struct Work {
    glm::dvec3 at{0}, towards{0};
    float ground;
};

// On the road, on the pavements (0.14 m up), and high on fronts, from where they rain.
constexpr Work works[] = {{{-2.6, 0.45, 4.2}, {0.5, 0.8, 0.3}, 0},    {{2.9, 0.6, 0.5}, {-0.7, 0.6, -0.2}, 0},
                          {{-7.6, 5.4, -3.5}, {1, 0.1, 0.2}, 0.14f},  {{0.6, 0.3, -7}, {0.1, 1, 0.3}, 0},
                          {{7.7, 6.2, -9.5}, {-1, -0.1, 0.1}, 0.14f}, {{-3.2, 0.5, -14}, {0.6, 0.7, 0.5}, 0},
                          {{-7.8, 3.2, -18.5}, {1, 0.3, 0}, 0.14f},   {{2.5, 0.5, -23}, {-0.3, 0.9, 0.4}, 0}};

glm::dmat4 aimed(const glm::dvec3& position, const glm::dvec3& direction) {
    const PlacedCamera placed = look_at({}, position, position + direction, {0.1, 1, 0.2});
    glm::dmat4 local(placed.axes);
    local[3] = {position, 1};
    return local;
}

} // namespace

Scene make_city_sparks(uint32_t lights, uint64_t seed) {
    const uint32_t own = std::max(lights / 9, 1u);
    Scene scene = make_city(own, seed);
    scene.name = "city-sparks";
    const uint32_t glow = append(scene.materials, Material{.name = "spark", .metallic = 0, .unlit = true});
    const auto places = static_cast<uint32_t>(std::size(works));
    for (uint32_t i = 0; i < places; ++i) {
        Emitter sparks{
            .count = (lights - own) / places + (i < (lights - own) % places ? 1 : 0),
            .seed = seed * 100 + i,
            .lifetime_from = 0.5f,
            .lifetime_to = 1.7f,
            .speed_from = 1.2f,
            .speed_to = 6,
            .cone = 0.75f,
            .radius = 0.03f,
            .ground = works[i].ground,
            .bounce = 0.35f,
            .slip = 0.6f,
            // White-hot, then orange, then red.
            .colours = {{1, 0.86f, 0.62f}, {1, 0.66f, 0.28f}, {0.8f, 0.34f, 0.08f}, {0.35f, 0.08f, 0.01f}, {0, 0, 0}},
            .intensity = 0.11f,
            .range = 0.8f,
            .size = 0.006f,
            .streak = 0.02f,
            .material = glow};
        if (sparks.count == 0)
            continue;
        add_root(scene, "sparks", aimed(works[i].at, works[i].towards)).emitter =
            append(scene.emitters, std::move(sparks));
    }
    return scene;
}

} // namespace prelight
