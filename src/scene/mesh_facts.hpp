#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <map>
#include <prelight/scene.hpp>
#include <vector>

namespace prelight {

/// Metres that a primitive's vertices may stand from their positions, whoever looks (Primitive::facing).
inline float facing_reach(const Primitive& primitive) {
    float reach = 0;
    for (const glm::vec2& offset : primitive.facing)
        reach = std::max(reach, std::hypot(offset.x, offset.y));
    return reach;
}

struct Bounds {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};
    void add(glm::dvec3 p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    bool empty() const { return !(min.x <= max.x); }
    bool finite() const {
        const glm::dvec3 sum = min + max;
        return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
    }
};

/// What resolve() needs of a mesh, gathered once.
struct MeshFacts {
    uint64_t triangles = 0;
    uint64_t vertices = 0;                   ///< that a triangle uses
    std::vector<std::vector<uint32_t>> used; ///< per primitive, sorted; empty: every vertex
    Bounds box;                              ///< object space
    std::map<uint16_t, Bounds> joint_boxes;  ///< by joint: of the vertices that it moves
    Bounds weightless;                       ///< of those that no joint moves
    size_t joints = 0;           ///< that its skin has to have: one more than the last that a vertex follows
    std::vector<Bounds> targets; ///< by morph target: what it adds, 0 included
};

MeshFacts facts_of(const Mesh& mesh);
/// Of all of the scene's, by index.
std::vector<MeshFacts> facts_of(const Scene& scene);

class Channels;

/// resolve() with facts_of(scene), and the channels of one of its animations or of all. Without `host_vertices`
/// World::deformed holds no vertices of meshes, what moves is bounded by boxes, and a world without cameras gets none.
World resolve(const Scene& scene, const std::vector<MeshFacts>& facts, const Channels& channels,
              std::optional<uint32_t> scene_index, const std::optional<Moment>& moment, bool host_vertices);

} // namespace prelight
