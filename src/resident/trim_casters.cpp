#include "trim_casters.hpp"
#include "trim_draws.hpp"
#include <algorithm>
#include <gpu/context.hpp>

namespace prelight::resident {

std::vector<VisibleDraw> trim_casters(const GpuScene& scene, std::span<const ShadowMap> maps,
                                      std::span<uint32_t> room) {
    const std::vector<Draw>& draws = scene.geometry().draws;
    std::vector<TrimView> views;
    std::vector<size_t> view_of; // of each caster
    std::vector<VisibleDraw> casters;
    std::vector<shared::ObjectData> objects;
    for (const ShadowMap& map : maps) {
        const auto side = static_cast<float>(map.place.side);
        views.push_back({.clip_from_world = map.clip_from_centre,
                         .width = side,
                         .height = side,
                         .subpixel_bits = scene.context().limits().subPixelPrecisionBits,
                         .both_faces = true});
        for (const uint32_t d : map.casters) {
            view_of.push_back(views.size() - 1);
            casters.push_back({.draw = d, .first_index = draws[d].first_index, .index_count = draws[d].index_count});
            std::ranges::copy(scene.caster_row(draws[d]), objects.emplace_back().world_row);
        }
    }
    double helpers_ms = 0;
    trim_draws(
        casters, objects, draws, [&](size_t c) -> const TrimView& { return views[view_of[c]]; }, room, helpers_ms);
    return casters;
}

} // namespace prelight::resident
