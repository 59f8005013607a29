#include "interleave.hpp"

#include <prelight/error.hpp>

namespace prelight::app {
namespace {

/// What one contender's frames took, milliseconds.
struct Samples {
    std::vector<double> wall, cpu, gpu;
    std::vector<std::vector<double>> passes, passes_cpu;
    double spent = 0;

    void add(const Stats& frame, double cost_ms) {
        wall.push_back(frame.wall_ms.median);
        cpu.push_back(frame.cpu_ms.median);
        gpu.push_back(frame.gpu_ms.median);
        passes.resize(frame.passes.size());
        passes_cpu.resize(frame.passes.size());
        for (size_t i = 0; i < passes.size(); ++i) {
            passes[i].push_back(frame.passes[i].gpu_ms.median);
            if (frame.passes[i].cpu_ms)
                passes_cpu[i].push_back(frame.passes[i].cpu_ms->median);
        }
        spent += cost_ms;
    }

    void put_into(Stats& stats) const {
        stats.frames = static_cast<uint32_t>(wall.size());
        stats.wall_ms = spread(wall);
        stats.cpu_ms = spread(cpu);
        stats.gpu_ms = spread(gpu);
        for (size_t i = 0; i < passes.size(); ++i) {
            stats.passes[i].gpu_ms = spread(passes[i]);
            if (!passes_cpu[i].empty())
                stats.passes[i].cpu_ms = spread(passes_cpu[i]);
        }
    }
};

} // namespace

void render_interleaved(std::vector<Contender>& contenders, const PlacedCamera& camera, const Rounds& rounds,
                        const std::function<void(const Contender&)>& before) {
    std::vector<Samples> samples(contenders.size());
    for (uint32_t round = 0; round < rounds.frames; ++round) {
        if (round > 0 && rounds.enough && rounds.enough())
            break;
        for (size_t i = 0; i < contenders.size(); ++i) {
            Contender& contender = contenders[i];
            if (before)
                before(contender);
            if (!contender.error.empty() || (round > 0 && samples[i].spent >= rounds.most_ms))
                continue;
            try {
                for (uint32_t repeat = 0; repeat < contender.repeats; ++repeat) {
                    contender.renderer->render(camera, 1);
                    contender.stats = contender.renderer->stats();
                    samples[i].add(contender.stats,
                                   rounds.cost_ms ? rounds.cost_ms(contender.stats) : contender.stats.wall_ms.median);
                }
            } catch (const Error& error) {
                contender.error = error.what();
            }
        }
    }
    for (size_t i = 0; i < contenders.size(); ++i)
        if (contenders[i].error.empty())
            samples[i].put_into(contenders[i].stats);
}

} // namespace prelight::app
