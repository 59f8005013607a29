#include "device_trimming.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <prelight/error.hpp>

namespace prelight::resident {
namespace {

constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

gpu::Buffer make(const gpu::Context& context, const char* name, uint64_t count, uint64_t stride,
                 VkBufferUsageFlags usage, gpu::BufferPlace place = gpu::BufferPlace::device) {
    return {context, name, std::max<uint64_t>(count, 1) * stride, storage | usage, place};
}

DeviceTrimming::Output make_output(const gpu::Context& context, uint64_t draws, uint64_t indices) {
    DeviceTrimming::Output out{
        make(context, "kept indices", indices, sizeof(uint32_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT),
        make(context, "trimmed draw commands", draws, sizeof(shared::IndexedCommand),
             VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT),
        {}};
    for (gpu::Buffer& one : out.host_counts)
        one = make(context, "kept index counts", draws, sizeof(uint32_t), 0, gpu::BufferPlace::readback);
    return out;
}

} // namespace

uint64_t DeviceTrimming::Output::triangles(uint32_t slot, std::span<const VisibleDraw> draws) const {
    const uint32_t* counts = host_counts[slot].mapped<uint32_t>();
    return std::accumulate(draws.begin(), draws.end(), uint64_t(0), [&](uint64_t sum, const VisibleDraw& one) {
        return sum + (one.device_trimmed ? counts[one.instance] : one.index_count) / 3;
    });
}

DeviceTrimming::DeviceTrimming(const gpu::Context& context, const Geometry& geometry, uint64_t indices,
                               const DrawOptions& options) {
    const uint64_t largest = std::max(geometry.positions.size(), geometry.indices.size());
    const uint64_t limit = context.limits().maxStorageBufferRange;
    if (largest > limit)
        throw Error(fmt::format("{}: index trimming on the device needs geometry in a storage buffer of {} bytes, and "
                                "the device's limit is {}",
                                context.name(), largest, limit));
    const uint64_t draws = geometry.draws.size();
    uint64_t groups = 0;
    for (const Draw& draw : geometry.draws)
        groups += (draw.index_count / 3 + TRIM_TRIANGLES - 1) / TRIM_TRIANGLES;
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot) {
        draws_[slot] = make(context, "draws to trim", draws, sizeof(shared::TrimDraw), 0, gpu::BufferPlace::upload);
        group_list_[slot] =
            make(context, "groups to trim", groups, sizeof(shared::TrimGroup), 0, gpu::BufferPlace::upload);
    }
    masks_ = make(context, "trimming masks", groups, sizeof(shared::TrimMask), 0);
    if (options.trimming == IndexTrimming::device)
        first_ = make_output(context, draws, indices);
    if (options.trims_by_depth)
        later_ = make_output(context, draws, indices);
}

void DeviceTrimming::update(uint32_t slot, const VisibleDraws& visible, const Geometry& geometry) {
    shared::TrimDraw* const records = draws_[slot].mapped<shared::TrimDraw>();
    shared::TrimGroup* const groups = group_list_[slot].mapped<shared::TrimGroup>();
    groups_ = 0;
    uint32_t to = 0;
    for (const VisibleDraw& one : visible.draws) {
        const Draw& draw = geometry.draws[one.draw];
        records[one.instance] = {
            .indices = {one.first_index, one.index_count, to, groups_},
            .state = {static_cast<uint32_t>(draw.vertex_offset),
                      (draw.mirrored ? TRIM_MIRRORED : 0u) | (draw.double_sided ? TRIM_DOUBLE_SIDED : 0u), 0, 0},
            .largest = glm::vec4(draw.largest(), 0)};
        if (!one.device_trimmed)
            continue;
        for (uint32_t t = 0; t < one.index_count / 3; t += TRIM_TRIANGLES)
            groups[groups_++] = {one.instance, t};
        to += one.index_count;
    }
}

} // namespace prelight::resident
