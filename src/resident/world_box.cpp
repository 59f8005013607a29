#include "world_box.hpp"
#include "scene.hpp"
#include <glm/common.hpp>

namespace prelight::resident {

namespace {

template <class Counts>
WorldBox around(std::span<const Draw> draws, Counts counts) {
    WorldBox box;
    bool first = true;
    for (const Draw& draw : draws) {
        if (!counts(draw))
            continue;
        box = first ? WorldBox{draw.low, draw.high}
                    : WorldBox{glm::min(box.low, draw.low), glm::max(box.high, draw.high)};
        first = false;
    }
    return box;
}

} // namespace

WorldBox box_around(std::span<const Draw> draws) {
    return around(draws, [](const Draw&) { return true; });
}

WorldBox box_around_layers(std::span<const Draw> draws) {
    return around(draws, [](const Draw& draw) { return draw.draw_class() != DrawClass::opaque; });
}

} // namespace prelight::resident
