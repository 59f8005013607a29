#include "smooth_groups.hpp"
#include <algorithm>
#include <cstring>
#include <numeric>
#include <unordered_map>

namespace prelight::resident {
namespace {

/// A vertex's place and normal, bit by bit.
struct Corner {
    glm::vec3 place{0}, normal{0};
    bool operator==(const Corner& other) const { return std::memcmp(this, &other, sizeof *this) == 0; }
};

struct CornerHash {
    size_t operator()(const Corner& corner) const {
        uint32_t words[6];
        std::memcpy(words, &corner, sizeof words);
        uint64_t hash = 0xcbf29ce484222325u; // FNV-1a
        for (const uint32_t word : words)
            hash = (hash ^ word) * 0x100000001b3u;
        return static_cast<size_t>(hash ^ (hash >> 29));
    }
};

/// Sets of vertices that are joined two by two, each known by its first vertex.
class Joined {
public:
    explicit Joined(size_t vertices) : first_(vertices) { std::iota(first_.begin(), first_.end(), 0u); }
    uint32_t first_of(uint32_t vertex) {
        while (first_[vertex] != vertex)
            vertex = first_[vertex] = first_[first_[vertex]];
        return vertex;
    }
    void join(uint32_t a, uint32_t b) {
        a = first_of(a);
        b = first_of(b);
        first_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<uint32_t> first_;
};

} // namespace

std::vector<uint32_t> smooth_groups(const Primitive& primitive) {
    const auto count = static_cast<uint32_t>(primitive.positions.size());
    Joined joined(count);
    for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        joined.join(primitive.indices[i], primitive.indices[i + 1]);
        joined.join(primitive.indices[i], primitive.indices[i + 2]);
    }
    std::unordered_map<Corner, uint32_t, CornerHash> known;
    known.reserve(count);
    for (uint32_t v = 0; v < count; ++v) {
        const glm::vec3 zero(0); // −0 and 0 are one place
        const Corner corner{primitive.positions[v] + zero, primitive.normals[v] + zero};
        joined.join(v, known.try_emplace(corner, v).first->second);
    }
    std::vector<uint32_t> groups(count);
    for (uint32_t v = 0; v < count; ++v)
        groups[v] = joined.first_of(v);
    return groups;
}

} // namespace prelight::resident
