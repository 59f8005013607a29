#include "visible_draws.hpp"
#include "facing_sorter.hpp"
#include "frustum.hpp"
#include "objects.hpp"
#include "sort_draws.hpp"
#include "trim_draws.hpp"
#include <algorithm>

namespace prelight::resident {
namespace {

void make_batches(VisibleDraws& out, const std::vector<Draw>& all, const DrawOptions& options) {
    // What is known draw by draw is of one object.
    const bool together = options.instanced && !options.counts_pixels && !options.trims_on_device();
    for (const VisibleDraw& one : out.of(DrawClass::opaque)) {
        const Draw& draw = all[one.draw];
        DrawBatch* last = out.batches.empty() ? nullptr : &out.batches.back();
        if (together && last && !one.trimmed && !last->trimmed && same_but_place(all[last->draw], draw)) {
            ++last->command.instanceCount;
            continue;
        }
        out.batches.push_back({one.draw,
                               one.trimmed,
                               one.device_trimmed,
                               {one.index_count, 1, one.first_index, draw.vertex_offset, one.instance}});
    }
}

/// Puts the triangles of draws that face the viewer into their order. `room`: behind `before` indices of other draws;
/// what does not fit keeps its own order. Returns the indices used.
size_t sort_facing(std::span<VisibleDraw> draws, std::span<const shared::ObjectData> objects, std::span<const Draw> all,
                   const glm::dvec3& forward, std::span<uint32_t> room, size_t before) {
    FacingSorter sorter(forward);
    size_t used = 0;
    for (size_t d = 0; d < draws.size(); ++d) {
        const Draw& draw = all[draws[d].draw];
        if (!draw.facing() || !draw.primitive || used + draw.index_count > room.size())
            continue;
        draws[d].first_index = static_cast<uint32_t>(before + used);
        draws[d].trimmed = true;
        used += sorter.sort(*draw.primitive, objects[d], &room[used]);
    }
    return used;
}

} // namespace

void find_visible(VisibleDraws& out, const Geometry& geometry, const World& world,
                  const shared::FrameConstants& constants, const gpu::Raster& raster, glm::dvec3 eye,
                  uint32_t subpixel_bits, const DrawOptions& options, const DrawBuffers& buffers) {
    const std::vector<Draw>& all = geometry.draws;
    out.draws.clear();
    out.batches.clear();
    out.triangles = 0;
    const Frustum frustum(constants.clip_from_world);
    std::array<std::vector<VisibleDraw>, draw_classes> others; // than opaque ones
    bool facing = false;
    for (uint32_t d = 0; d < all.size(); ++d)
        if (all[d].visible && (!options.frustum_culling || frustum.may_show(all[d], eye))) {
            const DrawClass which = all[d].draw_class();
            facing = facing || all[d].facing();
            (which == DrawClass::opaque ? out.draws : others[static_cast<size_t>(which)])
                .push_back({d, 0, all[d].first_index, all[d].index_count});
        }
    sort_by_distance(out.draws, all, eye, glm::dvec3(constants.forward), out.place);
    sort_back_to_front(others[static_cast<size_t>(DrawClass::blended)], all, eye, glm::dvec3(constants.forward));
    for (const std::vector<VisibleDraw>& of_class : others)
        out.draws.insert(out.draws.end(), of_class.begin(), of_class.end());
    out.place.assign(all.size(), no_image);

    const auto record = [&](uint32_t draw) {
        shared::ObjectData data = object_data(world.instances[all[draw].object], all[draw].normal_row, eye);
        data.normal_row[1].w = static_cast<float>(draw + 1);
        return data;
    };
    // Made first where triangles are chosen by them; else only where they stay.
    std::vector<shared::ObjectData>& objects = out.records;
    const bool first = options.trimming == IndexTrimming::host || facing;
    objects.resize(first ? out.draws.size() : 0);
    for (size_t d = 0; d < objects.size(); ++d)
        objects[d] = record(out.draws[d].draw);
    out.trimmed = 0;
    out.helpers_ms = 0;
    if (options.trimming == IndexTrimming::host)
        out.trimmed = trim_draws(out.draws, objects, all,
                                 {constants.clip_from_world, static_cast<float>(raster.extent.width),
                                  static_cast<float>(raster.extent.height), subpixel_bits, raster.samples},
                                 buffers.indices, out.helpers_ms);
    out.trimmed += sort_facing(out.draws, objects, all, glm::dvec3(constants.forward),
                               buffers.indices.subspan(out.trimmed), out.trimmed);
    size_t device_used = 0;
    uint32_t kept = 0;
    out.counts = {};
    for (size_t d = 0; d < out.draws.size(); ++d) {
        VisibleDraw one = out.draws[d];
        if (one.index_count == 0)
            continue;
        const DrawClass which = all[one.draw].draw_class();
        if (options.trims_on_device() && which == DrawClass::opaque && !all[one.draw].facing() &&
            device_used + one.index_count <= buffers.device_indices &&
            (options.trimming != IndexTrimming::host || one.trimmed)) {
            one.device_trimmed = true;
            device_used += one.index_count;
        }
        one.instance = kept;
        buffers.objects[kept] = first ? objects[d] : record(one.draw);
        out.place[one.draw] = kept;
        out.triangles += one.index_count / 3;
        out.draws[kept++] = one;
        ++out.counts[static_cast<size_t>(which)];
    }
    out.draws.resize(kept);
    make_batches(out, all, options);
    for (size_t b = 0; b < out.batches.size(); ++b)
        buffers.commands[b] = out.batches[b].command;
}

} // namespace prelight::resident
