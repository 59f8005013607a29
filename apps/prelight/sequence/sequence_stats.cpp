#include "sequence/sequence_stats.hpp"

#include <algorithm>

namespace prelight::app {
namespace {

constexpr size_t most_notes = 100; ///< some of them hold a frame's own figures

} // namespace

void SequenceStats::add(const Stats& stats) {
    const Stats before = std::move(all_);
    all_ = stats;
    all_.frames = before.frames + 1;
    all_.pairs_evaluated += before.pairs_evaluated;
    all_.pairs_contributing += before.pairs_contributing;
    all_.attachment_bytes = std::max(all_.attachment_bytes, before.attachment_bytes);
    all_.attachment_bytes_unshared = std::max(all_.attachment_bytes_unshared, before.attachment_bytes_unshared);
    all_.device_bytes = std::max(all_.device_bytes, before.device_bytes);
    if (all_.shadows && before.shadows) {
        all_.shadows->tiles_drawn += before.shadows->tiles_drawn;
        all_.shadows->tiles_reused += before.shadows->tiles_reused;
        all_.shadows->casters_drawn += before.shadows->casters_drawn;
    }
    if (all_.light_buffer && before.light_buffer)
        all_.light_buffer->clipped_pixels += before.light_buffer->clipped_pixels;
    if (all_.layers && before.layers) {
        all_.layers->most = std::max(all_.layers->most, before.layers->most);
        all_.layers->approximate += before.layers->approximate;
    }
    std::vector<std::string> notes = before.notes;
    for (const std::string& note : stats.notes)
        if (notes.size() < most_notes && std::ranges::find(notes, note) == notes.end())
            notes.push_back(note);
    all_.notes = std::move(notes);

    times_.wall.push_back(stats.wall_ms.median);
    times_.cpu.push_back(stats.cpu_ms.median);
    times_.gpu.push_back(stats.gpu_ms.median);
    if (stats.host_ms) {
        times_.lights.push_back(stats.host_ms->lights.median);
        times_.culling.push_back(stats.host_ms->culling.median);
        times_.objects.push_back(stats.host_ms->objects.median);
        times_.record.push_back(stats.host_ms->record.median);
    }
    // A pass that the last frame does not have keeps its place behind those that it has.
    for (const PassStats& pass : before.passes)
        if (std::ranges::find(all_.passes, pass.name, &PassStats::name) == all_.passes.end())
            all_.passes.push_back(pass);
    for (const PassStats& pass : stats.passes) {
        passes_[pass.name].gpu.push_back(pass.gpu_ms.median);
        if (pass.cpu_ms)
            passes_[pass.name].cpu.push_back(pass.cpu_ms->median);
    }
}

Stats SequenceStats::all() const {
    Stats all = all_;
    all.wall_ms = spread(times_.wall);
    all.cpu_ms = spread(times_.cpu);
    all.gpu_ms = spread(times_.gpu);
    if (!times_.record.empty())
        all.host_ms = {spread(times_.lights), spread(times_.culling), spread(times_.objects), spread(times_.record)};
    for (PassStats& pass : all.passes) {
        pass.gpu_ms = spread(passes_.at(pass.name).gpu);
        if (!passes_.at(pass.name).cpu.empty())
            pass.cpu_ms = spread(passes_.at(pass.name).cpu);
    }
    return all;
}

} // namespace prelight::app
