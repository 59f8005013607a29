#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace prelight::resident {

/// Where a tile lies in the atlas.
struct ShadowTilePlace {
    glm::uvec2 corner{0}; ///< texels
    uint32_t side = 0;    ///< texels, a power of two
    uint64_t first = 0;   ///< its first texel along the curve that ShadowAtlas numbers them by
    uint64_t end() const { return first + uint64_t(side) * side; }
    bool operator==(const ShadowTilePlace&) const = default;
};

/// Which tile: of which light, and which of its tiles.
struct ShadowTileKey {
    uint32_t light = 0, tile = 0;
    auto operator<=>(const ShadowTileKey&) const = default;
};

/// Square tiles in an atlas of one square or two beside each other, all with powers of two as sides. Texels
/// are numbered along a Z-order curve, so that a tile is a run of them and room is found as a buddy
/// allocator finds it: tiles that fit by their sum always fit. A tile stays where it is as long as its size
/// stays, unless there is no other way to make room.
class ShadowAtlas {
public:
    /// The largest atlas of at most `budget` ≥ 1 texels whose sides are at most `longest`.
    ShadowAtlas(uint64_t budget, uint32_t longest);
    glm::uvec2 size() const { return size_; }
    uint64_t texels() const { return uint64_t(size_.x) * size_.y; }
    /// The largest side of a tile.
    uint32_t largest() const { return size_.y; }

    struct Wish {
        ShadowTileKey key;
        uint32_t side = 1; ///< a power of two, at most largest()
    };
    /// Places for all tiles, in the order of `wishes`; their texels must not be more than texels().
    void place(const std::vector<Wish>& wishes, std::vector<ShadowTilePlace>& places);

private:
    struct Tile {
        uint64_t first = 0; ///< along the curve
        uint32_t level = 0; ///< side 2^level
        uint64_t seen = 0;  ///< the last call that wished for it
    };
    bool place_missing(const std::vector<Wish>& wishes);
    std::optional<uint64_t> take(uint32_t level);
    void give(uint64_t first, uint32_t level);
    void clear();
    ShadowTilePlace place_of(const Tile& tile) const;

    glm::uvec2 size_{1};
    std::vector<std::set<uint64_t>> free_; ///< by level: first texels of free squares
    std::map<ShadowTileKey, Tile> tiles_;
    uint64_t call_ = 0;
};

} // namespace prelight::resident
