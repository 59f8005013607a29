#include "coplanar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace prelight {
namespace {

struct Triangle {
    std::array<glm::dvec3, 3> corner{};
    glm::dvec3 normal{0}, low{0}, high{0};
    CoplanarPair::Face face;
    glm::vec4 colour{1};
    bool two_sided = false;
};

std::vector<Triangle> triangles(const World& world, double margin) {
    std::vector<Triangle> list;
    list.reserve(world.triangles);
    for (uint32_t i = 0; i < world.instances.size(); ++i) {
        const Instance& instance = world.instances[i];
        const auto& primitives = world.mesh_of(instance).primitives;
        for (uint32_t k = 0; k < primitives.size(); ++k) {
            const Primitive& p = primitives[k];
            for (uint32_t t = 0; 3 * t < p.indices.size(); ++t) {
                Triangle& out = list.emplace_back();
                for (uint32_t c = 0; c < 3; ++c)
                    out.corner[c] =
                        glm::dvec3(instance.transform * glm::dvec4(glm::dvec3(p.positions[p.indices[3 * t + c]]), 1));
                if (instance.mirrored)
                    std::swap(out.corner[1], out.corner[2]);
                const auto& [a, b, c] = out.corner;
                out.normal = glm::normalize(glm::cross(b - a, c - a));
                out.low = glm::min(glm::min(a, b), c) - margin;
                out.high = glm::max(glm::max(a, b), c) + margin;
                out.face = {i, k, t};
                if (!p.colours.empty())
                    out.colour = p.colours[p.indices[3 * t]];
                out.two_sided = world.scene->materials[p.material].double_sided;
            }
        }
    }
    return list;
}

/// The part of the convex polygon `points` where the distance function is positive.
template <typename Distance>
void clip(std::vector<glm::dvec3>& points, const Distance& distance) {
    std::vector<glm::dvec3> kept;
    for (size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3& p = points[i];
        const glm::dvec3& q = points[(i + 1) % points.size()];
        const double at_p = distance(p), at_q = distance(q);
        if (at_p > 0)
            kept.push_back(p);
        if ((at_p > 0) != (at_q > 0))
            kept.push_back(glm::mix(p, q, at_p / (at_p - at_q)));
    }
    points = std::move(kept);
}

/// Of triangle `a`: what lies over or under `b` and less than `distance` from b's plane.
std::vector<glm::dvec3> shared_part(const Triangle& a, const Triangle& b, double distance) {
    std::vector<glm::dvec3> part(a.corner.begin(), a.corner.end());
    const auto height = [&](const glm::dvec3& p) { return glm::dot(p - b.corner[0], b.normal); };
    clip(part, [&](const glm::dvec3& p) { return distance - height(p); });
    clip(part, [&](const glm::dvec3& p) { return distance + height(p); });
    for (size_t i = 0; i < 3; ++i) {
        const glm::dvec3 inward = glm::cross(b.normal, b.corner[(i + 1) % 3] - b.corner[i]);
        clip(part, [&](const glm::dvec3& p) { return glm::dot(p - b.corner[i], inward); });
    }
    return part;
}

class Finder {
public:
    Finder(std::vector<Triangle> list, double max_distance, double least_area)
        : all(std::move(list)), distance(max_distance), min_area(least_area) {}

    std::vector<CoplanarPair> run() {
        for (const auto& [cell, members] : by_normal()) {
            glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
            for (const uint32_t i : members) {
                low = glm::min(low, all[i].low);
                high = glm::max(high, all[i].high);
            }
            split(members, low, high);
        }
        std::sort(found.begin(), found.end(),
                  [](const CoplanarPair& p, const CoplanarPair& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
        return std::move(found);
    }

private:
    /// Groups of triangles that face nearly the same way; near a cell's border in several of them.
    /// The axes are in the middles of cells.
    std::map<std::array<int, 3>, std::vector<uint32_t>> by_normal() const {
        constexpr double margin = 0.0088; // more than the chord of 0.5°
        std::map<std::array<int, 3>, std::vector<uint32_t>> groups;
        const auto cell = [](double n) { return static_cast<int>(std::lround(4 * n)); };
        for (uint32_t i = 0; i < all.size(); ++i)
            for (const double sign : {1.0, -1.0}) {
                if (sign < 0 && !all[i].two_sided)
                    continue;
                const glm::dvec3 n = sign * all[i].normal, low = n - margin, high = n + margin;
                for (int x = cell(low.x); x <= cell(high.x); ++x)
                    for (int y = cell(low.y); y <= cell(high.y); ++y)
                        for (int z = cell(low.z); z <= cell(high.z); ++z)
                            groups[{x, y, z}].push_back(i);
            }
        return groups;
    }

    /// Halves the box until few triangles are left in it; one on the cut goes to both sides.
    void split(const std::vector<uint32_t>& members, const glm::dvec3& low, const glm::dvec3& high) {
        const glm::dvec3 size = high - low;
        int axis = size.x > size.y ? 0 : 1;
        axis = size[axis] > size.z ? axis : 2;
        if (members.size() < 24 || size[axis] < 0.02) // smaller than most of what is looked for
            return compare(members);
        const double cut = (low[axis] + high[axis]) / 2;
        std::vector<uint32_t> below, above;
        for (const uint32_t i : members) {
            if (all[i].low[axis] <= cut)
                below.push_back(i);
            if (all[i].high[axis] >= cut)
                above.push_back(i);
        }
        glm::dvec3 below_high = high, above_low = low;
        below_high[axis] = above_low[axis] = cut;
        split(below, low, below_high);
        split(above, above_low, high);
    }

    void compare(const std::vector<uint32_t>& members) {
        for (size_t i = 0; i < members.size(); ++i)
            for (size_t k = i + 1; k < members.size(); ++k)
                compare(members[i], members[k]);
    }

    void compare(uint32_t i, uint32_t k) {
        const Triangle &a = all[i], &b = all[k];
        constexpr double parallel = 0.99996192; // cos 0.5°
        const double turn = glm::dot(a.normal, b.normal);
        if ((a.two_sided || b.two_sided ? std::abs(turn) : turn) < parallel)
            return;
        if (glm::any(glm::lessThan(a.high, b.low)) || glm::any(glm::lessThan(b.high, a.low)))
            return;
        const bool same = a.face.instance == b.face.instance && a.face.primitive == b.face.primitive;
        if (same && a.colour == b.colour)
            return;
        const std::vector<glm::dvec3> part = shared_part(a, b, distance);
        glm::dvec3 doubled(0), middle(0);
        for (size_t n = 1; n + 1 < part.size(); ++n)
            doubled += glm::cross(part[n] - part[0], part[n + 1] - part[0]);
        const double area = glm::length(doubled) / 2;
        if (!(area > min_area) || !seen.insert({i, k}).second)
            return;
        for (const glm::dvec3& p : part)
            middle += p / static_cast<double>(part.size());
        found.push_back({a.face, b.face, area, middle, a.normal});
    }

    std::vector<Triangle> all;
    double distance, min_area;
    std::set<std::pair<uint32_t, uint32_t>> seen; ///< a pair may meet in several boxes
    std::vector<CoplanarPair> found;
};

} // namespace

std::vector<CoplanarPair> find_coplanar(const World& world, double distance, double min_area) {
    return Finder(triangles(world, distance), distance, min_area).run();
}

} // namespace prelight
