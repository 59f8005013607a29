#include "limit.hpp"

#include "pass_kind.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace prelight::app {
namespace {

struct Fastest {
    std::optional<double> ms;
    uint32_t tile = 0;
};

/// Perfect lists hold every pair that contributes. A pixel may fall on the other side of a light's
/// edge in another way of finding lights; more than that is light that was lost.
bool lacks_light(const Stats& perfect, const Stats& contender) {
    return double(perfect.pairs_contributing) < 0.999 * double(contender.pairs_contributing);
}

/// The quickest light pass among a contender's runs over such lists.
Fastest fastest_light(const Measured& measured, const Run& run, Role role, const std::vector<Job>& jobs, bool cpu,
                      std::vector<std::string>& missing) {
    Fastest best;
    for (const Job* job : jobs_for(*run.job, role, jobs))
        if (const Run* limit = measured.find(job, run.stop)) {
            if (role == Role::perfect && lacks_light(limit->stats, run.stats)) {
                const std::string line = fmt::format(
                    "{}, {} lights: the lists hold {:.2f} of {:.2f} million contributing pairs and are no limit",
                    job->name(), run.stop.lights, double(limit->stats.pairs_contributing) / 1e6,
                    double(run.stats.pairs_contributing) / 1e6);
                if (std::ranges::find(missing, line) == missing.end())
                    missing.push_back(line);
                continue;
            }
            const auto ms = passes_ms(limit->stats, PassKind::light, cpu);
            if (ms && (!best.ms || *ms < *best.ms))
                best = {ms, job->tile};
        }
    return best;
}

std::optional<double> sum(const std::optional<double>& a, const std::optional<double>& b) {
    return a || b ? std::optional(a.value_or(0) + b.value_or(0)) : std::nullopt;
}

LimitFigures figures_of(const Measured& measured, const Run& run, const Run& unit, const std::vector<Job>& jobs,
                        bool software, std::vector<std::string>& missing) {
    LimitFigures figures{.run = &run, .unit = &unit, .by_cpu = software};
    figures.passes_by_cpu = software && has_pass_cpu(run.stats) && has_pass_cpu(unit.stats);
    const auto frame = [&](const Stats& stats) { return (software ? stats.cpu_ms : stats.gpu_ms).median; };
    const bool cpu = figures.passes_by_cpu;
    figures.frame_ms = frame(run.stats);
    figures.unit_ms = frame(unit.stats);
    figures.unit_pass_ms = passes_ms(unit.stats, PassKind::other, cpu);
    for (const Job* job : jobs_for(*run.job, Role::no_lights, jobs))
        if (const Run* dark = measured.find(job, run.stop))
            figures.no_lights_ms = frame(dark->stats);
    if (!passes_ms(run.stats, PassKind::other, cpu)) // forward passes light and shade at once
        figures.geometry_ms =
            sum(passes_ms(run.stats, PassKind::geometry, cpu), passes_ms(run.stats, PassKind::material, cpu));
    figures.light_ms = passes_ms(run.stats, PassKind::light, cpu);
    figures.lists_ms = passes_ms(run.stats, PassKind::lists, cpu);
    const Fastest perfect = fastest_light(measured, run, Role::perfect, jobs, cpu, missing);
    const Fastest empty = fastest_light(measured, run, Role::empty, jobs, cpu, missing);
    figures.perfect_ms = perfect.ms;
    figures.perfect_tile = perfect.tile;
    figures.empty_ms = empty.ms;
    figures.empty_tile = empty.tile;
    return figures;
}

} // namespace

std::vector<LimitFigures> limit_figures(const Measured& measured, const std::vector<Job>& jobs, bool software,
                                        std::vector<std::string>& missing) {
    std::vector<LimitFigures> all;
    const auto unit_job = std::ranges::find(jobs, Role::unit, &Job::role);
    if (unit_job == jobs.end())
        return all;
    for (const Run& run : measured.runs)
        if (run.job->role == Role::contender)
            if (const Run* unit = measured.find(&*unit_job, run.stop))
                all.push_back(figures_of(measured, run, *unit, jobs, software, missing));
    return all;
}

} // namespace prelight::app
