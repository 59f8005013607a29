#include "frame_stats.hpp"
#include <platform/clocks.hpp>

namespace prelight {

CreatedObjects created_since(const gpu::Context& context, const CreatedObjects& before) {
    using Kind = gpu::Context::Kind;
    return {.allocations = context.created(Kind::allocation) - before.allocations,
            .pipelines = context.created(Kind::pipeline) - before.pipelines,
            .buffers = context.created(Kind::buffer) - before.buffers,
            .images = context.created(Kind::image) - before.images,
            .descriptor_pools = context.created(Kind::descriptor_pool) - before.descriptor_pools};
}

void FrameStats::start(uint32_t frames) {
    *this = {};
    frames_ = frames;
}

void FrameStats::add(double changes_ms, const resident::UpdateTimes& times, double record_ms,
                     const CreatedObjects& created, const UploadedBytes& uploaded) {
    lights_.push_back(changes_ms + times.lights);
    culling_.push_back(times.culling);
    objects_.push_back(times.objects);
    record_.push_back(record_ms);
    created_ = created;
    uploaded_ = uploaded;
}

void FrameStats::add_pass(size_t pass, double cpu_ms) {
    if (pass_cpu_.size() <= pass)
        pass_cpu_.resize(pass + 1);
    pass_cpu_[pass].push_back(cpu_ms);
}

void FrameStats::tell(Stats& stats, const FrameSamples& samples, const std::vector<graph::PassTraffic>& traffic) const {
    stats.frames = frames_;
    stats.wall_ms = spread(samples.wall);
    stats.cpu_ms = spread(samples.cpu);
    stats.gpu_ms = spread(samples.gpu);
    for (size_t p = 0; p < samples.passes.size(); ++p) {
        PassStats& pass = stats.passes.emplace_back();
        pass.name = samples.passes[p].first;
        pass.gpu_ms = spread(samples.passes[p].second);
        pass.bytes_read = traffic[p].bytes_read;
        pass.bytes_written = traffic[p].bytes_written;
        if (p < pass_cpu_.size())
            pass.cpu_ms = spread(pass_cpu_[p]);
    }
    stats.created = created_;
    stats.updated_bytes = uploaded_.updates;
    stats.frame_bytes = uploaded_.frame;
    stats.host_ms = HostTimes{spread(lights_), spread(culling_), spread(objects_), spread(record_)};
}

} // namespace prelight
