#include "table.hpp"

#include "pass_kind.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace prelight::app {
namespace {

/// A time: three digits that matter.
std::string ms(double value) {
    return value >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.{}f}", value, value >= 10 ? 1 : 2);
}

std::string spread_text(const Spread& spread) {
    return fmt::format("{} [{} … {}]", ms(spread.median), ms(spread.min), ms(spread.max));
}

template <typename Format>
std::string or_dash(const std::optional<double>& value, Format text) {
    return value ? text(*value) : "–";
}

std::string in_f(const std::optional<double>& value) {
    return or_dash(value, [](double v) { return fmt::format("{:.2f} F", v); });
}

/// Left of a table: the longest name decides how wide.
size_t name_width(const Measured& measured) {
    size_t width = 12;
    for (const Run& run : measured.runs)
        if (run.job->role == Role::contender)
            width = std::max(width, run.job->name().size());
    return width;
}

const LimitFigures* find(const std::vector<LimitFigures>& limits, const Run& run) {
    const auto found = std::ranges::find(limits, &run, &LimitFigures::run);
    return found == limits.end() ? nullptr : &*found;
}

/// Each pass; those that build lists, which are many and short, together.
void print_passes(const Stats& stats) {
    const bool cpu = has_pass_cpu(stats);
    std::string line;
    bool lists = false;
    for (const PassStats& pass : stats.passes) {
        const bool of_lists = kind_of(pass.name) == PassKind::lists;
        if (of_lists && lists)
            continue;
        lists = lists || of_lists;
        const double time =
            of_lists ? *passes_ms(stats, PassKind::lists, cpu) : (cpu ? *pass.cpu_ms : pass.gpu_ms).median;
        line += fmt::format("{}{} {}", line.empty() ? "" : ", ", of_lists ? "building lists" : pass.name, ms(time));
    }
    fmt::print("    {} ms: {}\n", cpu ? "CPU" : "device", line);
}

void print_run(const Run& run, const LimitFigures* limit, size_t width) {
    const Stats& stats = run.stats;
    uint64_t moved = 0;
    for (const PassStats& pass : stats.passes)
        moved += pass.bytes_read + pass.bytes_written;
    const double pixels = double(run.job->options.width) * double(run.job->options.height);
    const auto& counted = stats.pairs_counted;
    const std::string ratio =
        counted && stats.pairs_contributing
            ? fmt::format("{:.2f}", double(stats.pairs_evaluated) / double(stats.pairs_contributing))
            : "–";
    fmt::print("{:<{}}  {:>22}  {:>7}  {:>8}  {:>9}  {:>9.2f}  {:>7}  {:>7.1f}  {:>7.1f}  {:>8.1f}\n", run.job->name(),
               width, spread_text(stats.cpu_ms), limit ? fmt::format("{:.2f}", limit->frame_in_f()) : "–",
               ms(stats.wall_ms.median), ms(stats.gpu_ms.median), double(stats.pairs_evaluated) / 1e6, ratio,
               double(stats.attachment_bytes) / pixels, double(moved) / 1e6, double(stats.device_bytes) / 1e6);
    print_passes(stats);
}

} // namespace

void print_runs(const Measured& measured, const Stop& stop, const std::vector<LimitFigures>& limits) {
    const size_t width = name_width(measured);
    std::optional<uint64_t> lights;
    for (const Run& run : measured.runs) {
        if (run.job->role != Role::contender || run.stop.lights != stop.lights)
            continue;
        if (lights != run.stop.lights)
            fmt::print("\n{:<{}}  {:>22}  {:>7}  {:>8}  {:>9}  {:>9}  {:>7}  {:>7}  {:>7}  {:>8}\n",
                       fmt::format("{} light{}", run.stop.lights, run.stop.lights == 1 ? "" : "s"), width,
                       "CPU ms [min … max]", "F", "wall ms", "device ms", "pairs, M", "÷ contr", "B/pixel", "moved MB",
                       "device MB");
        lights = run.stop.lights;
        print_run(run, find(limits, run), width);
    }
}

void print_limits(const Stop& stop, const std::vector<LimitFigures>& limits) {
    std::optional<uint64_t> lights;
    size_t width = 12;
    for (const LimitFigures& f : limits)
        width = std::max(width, f.run->job->name().size());
    for (const LimitFigures& f : limits) {
        if (f.run->stop.lights != stop.lights)
            continue;
        if (lights != f.run->stop.lights)
            fmt::print("\nlimit, {} light{}: F is {} ms of {} time{}\n{:<{}}  {:>8}  {:>9}  {:>9}  {:>9}  {:>16}  "
                       "{:>8}  {:>8}  {:>8}\n",
                       f.run->stop.lights, f.run->stop.lights == 1 ? "" : "s",
                       spread_text(f.by_cpu ? f.unit->stats.cpu_ms : f.unit->stats.gpu_ms), f.by_cpu ? "CPU" : "device",
                       f.passes_by_cpu || !f.by_cpu ? "" : "; passes by device time", "", width, "frame", "no light",
                       "geometry", "light ms", "perfect lists ms", "÷ limit", "lists", "empty ms");
        lights = f.run->stop.lights;
        fmt::print("{:<{}}  {:>8}  {:>9}  {:>9}  {:>9}  {:>16}  {:>8}  {:>8}  {:>8}\n", f.run->job->name(), width,
                   in_f(f.frame_in_f()), in_f(f.no_lights_in_f()), in_f(f.geometry_in_f()), or_dash(f.light_ms, ms),
                   f.perfect_ms ? fmt::format("{} (tile {})", ms(*f.perfect_ms), f.perfect_tile) : "–",
                   or_dash(f.light_over_limit(), [](double v) { return fmt::format("{:.2f}", v); }),
                   or_dash(f.lists_over_light(), [](double v) { return fmt::format("{:.0f} %", 100 * v); }),
                   or_dash(f.empty_ms, ms));
    }
}

} // namespace prelight::app
