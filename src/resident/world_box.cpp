#include "world_box.hpp"
#include "scene.hpp"
#include <glm/common.hpp>
#include <ranges>

namespace prelight::resident {

namespace {

template <class Draws>
WorldBox around(Draws&& draws) {
    WorldBox box;
    bool first = true;
    for (const Draw& draw : draws) {
        box = first ? WorldBox{draw.low, draw.high}
                    : WorldBox{glm::min(box.low, draw.low), glm::max(box.high, draw.high)};
        first = false;
    }
    return box;
}

} // namespace

WorldBox box_around(std::span<const Draw> draws) { return around(draws); }

WorldBox box_around_layers(std::span<const Draw> draws) {
    return around(draws | std::views::filter([](const Draw& draw) { return draw.blended() || draw.transmissive(); }));
}

} // namespace prelight::resident
