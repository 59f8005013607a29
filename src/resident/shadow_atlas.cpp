#include "shadow_atlas.hpp"
#include <algorithm>
#include <bit>

namespace prelight::resident {
namespace {

uint32_t level_of(uint32_t side) { return static_cast<uint32_t>(std::countr_zero(side)); }

/// Every second bit of a place on the curve.
uint32_t every_second(uint64_t bits) {
    uint32_t out = 0;
    for (uint32_t b = 0; b < 32; ++b)
        out |= static_cast<uint32_t>(bits >> (2 * b) & 1) << b;
    return out;
}

} // namespace

ShadowAtlas::ShadowAtlas(uint64_t budget, uint32_t longest) {
    const uint32_t most = std::bit_floor(longest);
    uint64_t texels = 1;
    while (texels * 2 <= budget && size_.x < most) {
        (size_.x > size_.y ? size_.y : size_.x) *= 2;
        texels *= 2;
    }
    if (texels * 2 <= budget && size_.y < most)
        size_.y *= 2;
    free_.resize(level_of(size_.y) + 1);
    clear();
}

void ShadowAtlas::clear() {
    tiles_.clear();
    for (std::set<uint64_t>& level : free_)
        level.clear();
    const uint64_t square = uint64_t(size_.y) * size_.y;
    for (uint64_t first = 0; first < texels(); first += square)
        free_.back().insert(first);
}

std::optional<uint64_t> ShadowAtlas::take(uint32_t level) {
    uint32_t from = level;
    while (from < free_.size() && free_[from].empty())
        ++from;
    if (from == free_.size())
        return {};
    const uint64_t first = *free_[from].begin();
    free_[from].erase(free_[from].begin());
    while (from > level) { // three quarters stay free
        --from;
        for (uint64_t quarter = 1; quarter < 4; ++quarter)
            free_[from].insert(first + (quarter << (2 * from)));
    }
    return first;
}

void ShadowAtlas::give(uint64_t first, uint32_t level) {
    for (; level + 1 < free_.size(); ++level) { // where all four quarters are free they are one square
        const uint64_t quarter = uint64_t(1) << (2 * level), whole = first & ~(4 * quarter - 1);
        for (uint64_t q = 0; q < 4; ++q)
            if (whole + q * quarter != first && !free_[level].contains(whole + q * quarter)) {
                free_[level].insert(first);
                return;
            }
        for (uint64_t q = 0; q < 4; ++q)
            free_[level].erase(whole + q * quarter);
        first = whole;
    }
    free_[level].insert(first);
}

ShadowTilePlace ShadowAtlas::place_of(const Tile& tile) const {
    const uint64_t square = uint64_t(size_.y) * size_.y, inside = tile.first % square;
    return {{every_second(inside) + static_cast<uint32_t>(tile.first / square) * size_.y, every_second(inside >> 1)},
            1u << tile.level,
            tile.first};
}

bool ShadowAtlas::place_missing(const std::vector<Wish>& wishes) {
    std::vector<Wish> missing;
    for (const Wish& wish : wishes)
        if (!tiles_.contains(wish.key))
            missing.push_back(wish);
    std::stable_sort(missing.begin(), missing.end(), [](const Wish& a, const Wish& b) { return a.side > b.side; });
    for (const Wish& wish : missing) {
        const uint32_t level = level_of(wish.side);
        const std::optional<uint64_t> first = take(level);
        if (!first)
            return false;
        tiles_[wish.key] = {*first, level, call_};
    }
    return true;
}

void ShadowAtlas::place(const std::vector<Wish>& wishes, std::vector<ShadowTilePlace>& places) {
    ++call_;
    for (const Wish& wish : wishes)
        if (const auto found = tiles_.find(wish.key);
            found != tiles_.end() && found->second.level == level_of(wish.side))
            found->second.seen = call_;
    std::erase_if(tiles_, [&](const auto& entry) {
        if (entry.second.seen == call_)
            return false;
        give(entry.second.first, entry.second.level);
        return true;
    });
    if (!place_missing(wishes)) { // room is there, in pieces: from the largest to the smallest all fit
        clear();
        place_missing(wishes);
    }
    places.clear();
    for (const Wish& wish : wishes)
        places.push_back(place_of(tiles_.at(wish.key)));
}

} // namespace prelight::resident
