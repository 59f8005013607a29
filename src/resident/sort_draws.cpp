#include "sort_draws.hpp"
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

namespace prelight::resident {
namespace {

struct Key {
    double run, own; ///< metres along the view
    uint32_t number; ///< in the order that they came in
    uint32_t draw;
    bool operator<(const Key& other) const {
        return std::tie(run, own, number) < std::tie(other.run, other.own, other.number);
    }
};

double depth_of(const Draw& draw, const glm::dvec3& eye, const glm::dvec3& forward) {
    return glm::dot(0.5 * (draw.low + draw.high) - eye, forward);
}

std::vector<Key> keys_of(const std::vector<VisibleDraw>& draws, const std::vector<Draw>& all, const glm::dvec3& eye,
                         const glm::dvec3& forward) {
    std::vector<Key> keys;
    keys.reserve(draws.size());
    for (size_t begin = 0; begin < draws.size();) {
        double nearest = std::numeric_limits<double>::infinity();
        size_t end = begin;
        for (; end < draws.size() && same_but_place(all[draws[begin].draw], all[draws[end].draw]); ++end) {
            const Draw& draw = all[draws[end].draw];
            const double own = depth_of(draw, eye, forward);
            keys.push_back({0, own, static_cast<uint32_t>(end), draws[end].draw});
            nearest = std::min(nearest, own);
        }
        for (; begin < end; ++begin)
            keys[begin].run = nearest;
    }
    return keys;
}

/// Into the order of the frame before, and what was not in it behind.
std::vector<Key> as_before(const std::vector<Key>& keys, std::span<const uint32_t> before) {
    std::vector<uint32_t> at(before.size(), no_image), ordered;
    ordered.reserve(keys.size());
    const auto place = [&](const Key& key) { return key.draw < before.size() ? before[key.draw] : no_image; };
    for (const Key& key : keys)
        if (place(key) != no_image)
            at[place(key)] = key.number;
    for (const uint32_t number : at)
        if (number != no_image)
            ordered.push_back(number);
    for (const Key& key : keys)
        if (place(key) == no_image)
            ordered.push_back(key.number);
    std::vector<Key> out;
    out.reserve(keys.size());
    for (const uint32_t number : ordered)
        out.push_back(keys[number]);
    return out;
}

/// Few steps where few are out of place; many are given up for a whole sort.
void sort_nearly_sorted(std::vector<Key>& keys) {
    size_t steps = 4 * keys.size() + 64;
    for (size_t i = 1; i < keys.size(); ++i) {
        const Key key = keys[i];
        size_t j = i;
        for (; j > 0 && key < keys[j - 1] && steps > 0; --j, --steps)
            keys[j] = keys[j - 1];
        keys[j] = key;
        if (steps == 0)
            return std::sort(keys.begin(), keys.end());
    }
}

} // namespace

bool same_but_place(const Draw& a, const Draw& b) {
    return a.features == b.features && a.material == b.material && a.mirrored == b.mirrored &&
           a.first_index == b.first_index && a.index_count == b.index_count && a.vertex_offset == b.vertex_offset;
}

void sort_by_distance(std::vector<VisibleDraw>& draws, const std::vector<Draw>& all, const glm::dvec3& eye,
                      const glm::dvec3& forward, std::span<const uint32_t> before) {
    std::vector<Key> keys = as_before(keys_of(draws, all, eye, forward), before);
    sort_nearly_sorted(keys);
    for (size_t i = 0; i < keys.size(); ++i)
        draws[i] = {keys[i].draw, 0, all[keys[i].draw].first_index, all[keys[i].draw].index_count};
}

void sort_back_to_front(std::vector<VisibleDraw>& draws, const std::vector<Draw>& all, const glm::dvec3& eye,
                        const glm::dvec3& forward) {
    const auto key = [&](const VisibleDraw& one) {
        const Draw& draw = all[one.draw];
        return std::tuple(depth_of(draw, eye, forward), draw.object, draw.part);
    };
    std::sort(draws.begin(), draws.end(), [&](const VisibleDraw& a, const VisibleDraw& b) { return key(a) > key(b); });
}

} // namespace prelight::resident
