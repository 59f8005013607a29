#include "world_box.hpp"
#include "scene.hpp"
#include <glm/common.hpp>

namespace prelight::resident {

WorldBox box_around(std::span<const Draw> draws) {
    if (draws.empty())
        return {};
    WorldBox box{draws[0].low, draws[0].high};
    for (const Draw& draw : draws)
        box = {glm::min(box.low, draw.low), glm::max(box.high, draw.high)};
    return box;
}

} // namespace prelight::resident
