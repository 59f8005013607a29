#include "trim_casters.hpp"
#include "trim_indices.hpp"
#include <algorithm>
#include <cstring>
#include <gpu/context.hpp>
#include <parallel/parallel_for.hpp>

namespace prelight::resident {
namespace {

/// Maps that one thread takes at a time.
struct MapChunk {
    size_t first = 0, count = 0;
    size_t casters_before = 0;
    size_t indices = 0;         ///< of all their casters
    std::vector<uint32_t> kept; ///< of these, one caster after the other
};

std::vector<MapChunk> chunks_of(std::span<const ShadowMap> maps, std::span<const Draw> draws) {
    std::vector<MapChunk> chunks;
    size_t casters = 0;
    for (size_t m = 0; m < maps.size(); ++m) {
        if (chunks.empty() || chunks.back().indices >= indices_of_a_thread)
            chunks.push_back({.first = m, .casters_before = casters, .kept = {}});
        ++chunks.back().count;
        for (const uint32_t d : maps[m].casters)
            chunks.back().indices += draws[d].index_count;
        casters += maps[m].casters.size();
    }
    return chunks;
}

void trim(MapChunk& chunk, const GpuScene& scene, std::span<const ShadowMap> maps, TrimmedCaster* out) {
    const std::vector<Draw>& draws = scene.geometry().draws;
    const auto room = std::make_unique_for_overwrite<uint32_t[]>(chunk.indices);
    size_t used = 0;
    IndexTrimmer trimmer({});
    for (const ShadowMap& map : maps.subspan(chunk.first, chunk.count)) {
        const auto side = static_cast<float>(map.place.side);
        trimmer.look_from({.clip_from_world = map.clip_from_centre,
                           .width = side,
                           .height = side,
                           .subpixel_bits = scene.context().limits().subPixelPrecisionBits,
                           .both_faces = true});
        for (const uint32_t d : map.casters) {
            const Draw& draw = draws[d];
            TrimmedCaster& caster = *out++;
            caster = {draw.first_index, draw.index_count, can_be_trimmed(draw)};
            if (!caster.trimmed)
                continue;
            shared::ObjectData object{};
            std::ranges::copy(scene.caster_row(draw), object.world_row);
            caster.first_index = static_cast<uint32_t>(used); // of the chunk
            caster.index_count = static_cast<uint32_t>(trimmer.trim(draw, object, &room[used]));
            used += caster.index_count;
        }
    }
    chunk.kept.assign(room.get(), room.get() + used);
}

} // namespace

std::vector<TrimmedCaster> trim_casters(const GpuScene& scene, std::span<const ShadowMap> maps,
                                        std::span<uint32_t> room) {
    const std::vector<Draw>& draws = scene.geometry().draws;
    std::vector<MapChunk> chunks = chunks_of(maps, draws);
    size_t casters = 0;
    for (const ShadowMap& map : maps)
        casters += map.casters.size();
    std::vector<TrimmedCaster> out(casters);
    parallel_for(static_cast<uint32_t>(chunks.size()),
                 [&](uint32_t c) { trim(chunks[c], scene, maps, &out[chunks[c].casters_before]); });
    size_t used = 0;
    for (const MapChunk& chunk : chunks) {
        TrimmedCaster* caster = &out[chunk.casters_before];
        const bool fits = used + chunk.kept.size() <= room.size();
        for (const ShadowMap& map : maps.subspan(chunk.first, chunk.count))
            for (const uint32_t d : map.casters) {
                if (caster->trimmed && fits)
                    caster->first_index += static_cast<uint32_t>(used);
                else
                    *caster = {draws[d].first_index, draws[d].index_count};
                ++caster;
            }
        if (!fits)
            continue;
        std::ranges::copy(chunk.kept, room.begin() + static_cast<std::ptrdiff_t>(used));
        used += chunk.kept.size();
    }
    return out;
}

} // namespace prelight::resident
