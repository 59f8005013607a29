#include <algorithm>
#include <reference/passed_surfaces.hpp>
#include <tuple>

namespace prelight::reference {
namespace {

/// Of a distance: what double precision makes of two planes that are one.
constexpr double one_place = 1e-9;

/// Whether two triangles of a draw, met from one side, were met on an edge or a corner of both.
bool meet_there(const Crossing& a, const Crossing& b, const Draw& draw) {
    if (a.draw != b.draw || a.along != b.along)
        return false;
    const auto corner = [&](const Crossing& one, int i) {
        return draw.primitive->positions[draw.primitive->indices[size_t(one.triangle) * 3 + i]];
    };
    int shared = 0;
    double rest_a = 1, rest_b = 1; // weights of the corners that they do not share
    const glm::dvec3 weights_a(1 - a.place.x - a.place.y, a.place.x, a.place.y);
    const glm::dvec3 weights_b(1 - b.place.x - b.place.y, b.place.x, b.place.y);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            if (corner(a, i) == corner(b, k)) {
                ++shared;
                rest_a -= weights_a[i];
                rest_b -= weights_b[k];
            }
    constexpr double rounding = 1e-4; // of Embree's single precision, with room
    return shared > 0 && shared < 3 && rest_a < rounding && rest_b < rounding;
}

} // namespace

uint64_t scattered(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

uint64_t hash_of(std::vector<Hole>& holes, double limit) {
    std::sort(holes.begin(), holes.end(), [](const Hole& a, const Hole& b) {
        return a.draw != b.draw ? a.draw < b.draw : a.distance < b.distance;
    });
    uint64_t hash = 0;
    for (size_t i = 0; i < holes.size(); ++i) {
        // A ray through an edge meets both triangles there, which is one hole.
        const bool again = i > 0 && holes[i].draw == holes[i - 1].draw &&
                           holes[i].distance - holes[i - 1].distance < 1e-5 * holes[i].distance;
        if (!again && holes[i].distance < limit)
            hash += scattered(holes[i].draw * uint64_t(2));
    }
    return hash;
}

void leave_one_each(std::vector<Crossing>& crossed, std::span<const Draw> draws) {
    const auto key = [](const Crossing& one) { return std::tuple(one.draw, one.triangle); };
    std::sort(crossed.begin(), crossed.end(), [&](const Crossing& a, const Crossing& b) { return key(a) < key(b); });
    std::vector<Crossing> kept;
    size_t first = 0; // of the draw's
    for (const Crossing& one : crossed) {
        if (first < kept.size() && kept[first].draw != one.draw)
            first = kept.size();
        if (std::none_of(kept.begin() + first, kept.end(), [&](const Crossing& other) {
                return key(other) == key(one) || meet_there(other, one, draws[one.draw]);
            }))
            kept.push_back(one);
    }
    crossed = std::move(kept);
}

void front_to_back(std::vector<Hit>& layers, double limit) {
    std::erase_if(layers, [&](const Hit& one) { return one.distance > limit * (1 + one_place); });
    std::sort(layers.begin(), layers.end(), [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
    // Runs of one distance by the scene's order. A comparison with a tolerance would be no order.
    for (auto first = layers.begin(); first != layers.end();) {
        auto last = first + 1;
        while (last != layers.end() && last->distance <= (last - 1)->distance * (1 + one_place))
            ++last;
        std::sort(first, last, [](const Hit& a, const Hit& b) {
            return std::tuple(a.draw, a.triangle) < std::tuple(b.draw, b.triangle);
        });
        first = last;
    }
}

} // namespace prelight::reference
