#include "visible_draws.hpp"
#include "objects.hpp"
#include "trim_indices.hpp"
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <limits>
#include <tuple>

namespace prelight::resident {
namespace {

/// Draws that one call may show: same state, same triangles.
bool same_but_place(const Draw& a, const Draw& b) {
    return a.features == b.features && a.material == b.material && a.mirrored == b.mirrored &&
           a.first_index == b.first_index && a.index_count == b.index_count && a.vertex_offset == b.vertex_offset;
}

/// Occluders first: draws that differ in nothing but their place stay together, front to back, and these runs
/// follow one another by their nearest draw.
void sort_by_distance(std::vector<VisibleDraw>& draws, const std::vector<Draw>& all, glm::dvec3 eye,
                      glm::dvec3 forward) {
    struct Key {
        double run, own; ///< metres along the view
        uint32_t draw;
    };
    std::vector<Key> keys;
    keys.reserve(draws.size());
    for (size_t begin = 0; begin < draws.size();) {
        double nearest = std::numeric_limits<double>::infinity();
        size_t end = begin;
        for (; end < draws.size() && same_but_place(all[draws[begin].draw], all[draws[end].draw]); ++end) {
            const Draw& draw = all[draws[end].draw];
            const double own = glm::dot(0.5 * (draw.low + draw.high) - eye, forward);
            keys.push_back({0, own, draws[end].draw});
            nearest = std::min(nearest, own);
        }
        for (; begin < end; ++begin)
            keys[begin].run = nearest;
    }
    std::stable_sort(keys.begin(), keys.end(),
                     [&](const Key& a, const Key& b) { return std::tie(a.run, a.own) < std::tie(b.run, b.own); });
    for (size_t i = 0; i < keys.size(); ++i)
        draws[i] = {keys[i].draw, 0, all[keys[i].draw].first_index, all[keys[i].draw].index_count};
}

void make_batches(VisibleDraws& out, const std::vector<Draw>& all, const DrawOptions& options) {
    // What is known draw by draw is of one object.
    const bool together = options.instanced && !options.counts_pixels && !options.trims_on_device();
    for (const VisibleDraw& one : out.draws) {
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

} // namespace

bool may_show(const Draw& draw, const glm::mat4& clip_from_world, glm::dvec3 eye) {
    const glm::dvec3 middle = 0.5 * (draw.low + draw.high) - eye, half = 0.5 * (draw.high - draw.low);
    glm::dvec4 row[4];
    for (int r = 0; r < 4; ++r)
        row[r] = glm::row(clip_from_world, r);
    // A point is in the picture when all of these are ≥ 0: |x| ≤ w, |y| ≤ w, 0 ≤ z ≤ w.
    const glm::dvec4 planes[] = {row[3] + row[0], row[3] - row[0], row[3] + row[1],
                                 row[3] - row[1], row[3] - row[2], row[2]};
    for (const glm::dvec4& plane : planes) {
        const glm::dvec3 normal(plane);
        const double most = glm::dot(normal, middle) + glm::dot(glm::abs(normal), half) + plane.w;
        const double rounding = 1e-5 * (glm::dot(glm::abs(normal), glm::abs(middle) + half) + std::abs(plane.w));
        if (most < -rounding)
            return false;
    }
    return true;
}

void find_visible(VisibleDraws& out, const Geometry& geometry, const World& world,
                  const shared::FrameConstants& constants, VkExtent2D extent, glm::dvec3 eye, uint32_t subpixel_bits,
                  const DrawOptions& options, const DrawBuffers& buffers) {
    const std::vector<Draw>& all = geometry.draws;
    out.draws.clear();
    out.batches.clear();
    out.place.assign(all.size(), no_image);
    out.triangles = 0;
    for (uint32_t d = 0; d < all.size(); ++d)
        if (all[d].visible && (!options.frustum_culling || may_show(all[d], constants.clip_from_world, eye)))
            out.draws.push_back({d, 0, all[d].first_index, all[d].index_count});
    sort_by_distance(out.draws, all, eye, glm::dvec3(constants.forward));

    IndexTrimmer trimmer({constants.clip_from_world, static_cast<float>(extent.width),
                          static_cast<float>(extent.height), subpixel_bits});
    size_t used = 0, device_used = 0;
    uint32_t kept = 0;
    for (VisibleDraw one : out.draws) {
        const Draw& draw = all[one.draw];
        const shared::ObjectData object = object_data(world.instances[draw.object], eye);
        if (options.trimming == IndexTrimming::host && draw.primitive &&
            used + draw.index_count <= buffers.indices.size()) {
            one.first_index = static_cast<uint32_t>(used);
            one.index_count = static_cast<uint32_t>(
                trimmer.trim(*draw.primitive, object, draw.mirrored, draw.double_sided, &buffers.indices[used]));
            one.trimmed = true;
            used += one.index_count;
        }
        if (one.index_count == 0)
            continue;
        if (options.trims_on_device() && device_used + one.index_count <= buffers.device_indices &&
            (options.trimming != IndexTrimming::host || one.trimmed)) {
            one.device_trimmed = true;
            device_used += one.index_count;
        }
        one.instance = kept;
        buffers.objects[kept] = object;
        out.place[one.draw] = kept;
        out.triangles += one.index_count / 3;
        out.draws[kept++] = one;
    }
    out.draws.resize(kept);
    out.trimmed = used;
    make_batches(out, all, options);
    for (size_t b = 0; b < out.batches.size(); ++b)
        buffers.commands[b] = out.batches[b].command;
}

} // namespace prelight::resident
