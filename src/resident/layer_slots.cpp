#include "layer_slots.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace prelight::resident {
namespace {

/// Texels from the left and upper edge.
struct Rectangle {
    glm::dvec2 low{0}, high{0};
    bool empty() const { return low.x >= high.x || low.y >= high.y; }
    bool meets(const Rectangle& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
};

/// Around a box on the screen, a texel wider on each side; all of the picture where it reaches behind the camera.
Rectangle rectangle_of(const Draw& draw, const glm::dmat4& clip_from_object, const glm::dvec2& size) {
    Rectangle out{glm::dvec2(std::numeric_limits<double>::infinity()),
                  glm::dvec2(-std::numeric_limits<double>::infinity())};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at(corner & 1 ? draw.own_high.x : draw.own_low.x,
                            corner & 2 ? draw.own_high.y : draw.own_low.y,
                            corner & 4 ? draw.own_high.z : draw.own_low.z);
        const glm::dvec4 clip = clip_from_object * glm::dvec4(at, 1);
        if (clip.w <= 0)
            return {glm::dvec2(0), size};
        const glm::dvec2 place = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * size;
        out.low = glm::min(out.low, place - 1.0);
        out.high = glm::max(out.high, place + 1.0);
    }
    out.low = glm::max(out.low, glm::dvec2(0));
    out.high = glm::min(out.high, size);
    return out;
}

} // namespace

void find_layer_slots(LayerSlots& out, const Geometry& geometry, const World& world,
                      const shared::FrameConstants& constants, glm::dvec3 eye, VkExtent2D extent) {
    out.of.assign(geometry.draws.size(), 0);
    out.drawn = out.without_own = 0;
    std::vector<uint32_t> blended; // in the world's order, seen or not
    for (const std::vector<uint32_t>& draws : geometry.draws_of) {
        const size_t first = blended.size();
        for (const uint32_t d : draws)
            if (geometry.draws[d].blended())
                blended.push_back(d);
        std::sort(blended.begin() + static_cast<ptrdiff_t>(first), blended.end(),
                  [&](uint32_t a, uint32_t b) { return geometry.draws[a].part < geometry.draws[b].part; });
    }
    std::array<std::vector<Rectangle>, 3> taken;
    for (uint32_t number = 0; number < blended.size(); ++number) {
        const Draw& draw = geometry.draws[blended[number]];
        if (!draw.visible)
            continue;
        glm::dmat4 to_eye = world.instances[draw.object].transform;
        to_eye[3] -= glm::dvec4(eye, 0);
        const Rectangle own =
            rectangle_of(draw, glm::dmat4(constants.clip_from_world) * to_eye, glm::dvec2(extent.width, extent.height));
        if (own.empty())
            continue;
        uint32_t slot = number % 3;
        const auto is_free = [&](uint32_t one) {
            return std::none_of(taken[one].begin(), taken[one].end(),
                                [&](const Rectangle& other) { return own.meets(other); });
        };
        for (const uint32_t one : {number % 3, (number + 1) % 3, (number + 2) % 3})
            if (is_free(one)) {
                slot = one;
                break;
            }
        out.without_own += !is_free(slot);
        taken[slot].push_back(own);
        out.of[blended[number]] = slot + 1;
        ++out.drawn;
    }
}

} // namespace prelight::resident
