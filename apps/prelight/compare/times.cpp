#include "times.hpp"

#include "interleave.hpp"
#include "log.hpp"
#include "stats_state.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <thread>

namespace prelight::app {
namespace {

/// One number of lights at which runs are timed.
struct Stop {
    std::optional<uint32_t> lights; ///< as --light-counts says; nothing: the scene's own
    uint64_t total = 0;             ///< lights in the world
    bool own() const { return !lights; }
};

std::vector<Stop> make_stops(const Report& report, const SceneSeries& scenes) {
    std::vector<Stop> stops{{{}, report.lights}};
    for (const uint32_t count : report.command.light_counts)
        if (scenes.total(count) != report.lights) // that one is there already
            stops.push_back({count, scenes.total(count)});
    std::ranges::stable_sort(stops, {}, &Stop::total);
    return stops;
}

/// What a frame costs, milliseconds: of a software device what it would take by itself on this machine.
double frame_ms(const Stats& stats, bool software) {
    const double threads = std::max(1u, std::thread::hardware_concurrency());
    return software ? std::min(stats.wall_ms.median, stats.cpu_ms.median / threads) : stats.wall_ms.median;
}

/// A run with the renderer that is timed: without views and without counting pairs, which cost time.
struct Timed {
    RunReport& run;
    std::unique_ptr<Renderer> renderer;

    bool wanted_at(const Stop& stop) const {
        return run.error.empty() && (stop.own() || (run.in_series && run.stopped.empty()));
    }

    /// False when the renderer cannot take the world or the lights; the run then says why.
    bool take(const World& world, const std::vector<PlacedLight>& lights, Device& device, const Stop& stop) {
        try {
            if (!renderer) {
                renderer = create_renderer(run.variant.renderer, &device, run.options);
                renderer->set_world(world);
            }
            renderer->set_lights(lights);
            return true;
        } catch (const UsageError& error) {
            run.wrong_usage = stop.own();
            fail(error.what(), stop);
        } catch (const Error& error) {
            fail(error.what(), stop);
        }
        return false;
    }

    void fail(const std::string& reason, const Stop& stop) {
        (stop.own() ? run.error : run.stopped) = reason;
        renderer.reset();
    }

    void keep(Stats stats, const Stop& stop, double frame_limit, bool software) {
        if (run.in_series && run.stopped.empty())
            run.series.push_back(stats);
        const double seconds = frame_ms(stats, software) / 1000;
        if (seconds > frame_limit && run.stopped.empty())
            run.stopped = fmt::format("no more than {} light{}: a frame took {:.1f} s (--frame-limit {:g})",
                                      stats.lights, stats.lights == 1 ? "" : "s", seconds, frame_limit);
        if (!stop.own())
            return;
        stats.pairs_counted = run.stats.pairs_counted;
        stats.pairs_evaluated = run.stats.pairs_evaluated;
        stats.pairs_contributing = run.stats.pairs_contributing;
        run.stats = std::move(stats);
    }
};

/// Takes what a process before has measured at the stop; false: not all of it is there.
bool find_times(const Stop& stop, const nlohmann::json* state, std::vector<Timed>& all, const Report& report) {
    const auto unknown = [&](const Timed& timed) {
        return timed.wanted_at(stop) && !(state && state->contains(timed.run.variant.name()));
    };
    if (!state || std::ranges::any_of(all, unknown))
        return false;
    for (Timed& timed : all)
        if (timed.wanted_at(stop)) {
            const nlohmann::json& figures = state->at(timed.run.variant.name());
            if (figures.is_string())
                timed.fail(figures, stop);
            else
                timed.keep(stats_from_state(figures), stop, report.command.frame_limit, report.software());
        }
    return true;
}

/// `most_seconds`: for all of it, unless one round takes longer. Says how many rounds there were.
uint32_t time_at(const Stop& stop, const World& world, const std::vector<PlacedLight>& lights, const Report& report,
                 std::vector<Timed>& all, Device& device, KeptSteps& kept, double most_seconds,
                 const std::function<void(double, const std::string&)>& show) {
    const TimeBudget own(most_seconds);
    const std::string step = fmt::format("times of {}", stop.total);
    if (find_times(stop, kept.find(step), all, report))
        return report.command.frames;
    nlohmann::json figures = nlohmann::json::object();
    std::vector<Contender> contenders;
    std::vector<Timed*> owners;
    for (Timed& timed : all)
        if (timed.wanted_at(stop)) {
            show(0, "upload for " + timed.run.variant.name());
            if (timed.take(world, lights, device, stop)) {
                contenders.push_back({.renderer = timed.renderer.get()});
                owners.push_back(&timed);
            } else
                figures[timed.run.variant.name()] = stop.own() ? timed.run.error : timed.run.stopped;
        }
    const CompareCommand& command = report.command;
    const double frames = std::max<double>(1, double(command.frames) * double(contenders.size()));
    size_t frame = 0;
    uint32_t rounds = 1;
    const auto enough = [&] {
        // Another round takes about as long as one did.
        const bool over = own.left() < own.spent() / (rounds + 1);
        rounds += over ? 0 : 1;
        return over;
    };
    render_interleaved(contenders, camera_of(world, command.camera),
                       {.frames = command.frames,
                        .most_ms = command.frame_limit * 1000,
                        .cost_ms = [&](const Stats& stats) { return frame_ms(stats, report.software()); },
                        .enough = enough},
                       [&](const Contender& contender) {
                           const auto index = static_cast<size_t>(&contender - contenders.data());
                           show(double(frame++) / frames, owners[index]->run.variant.name());
                       });
    for (size_t i = 0; i < contenders.size(); ++i) {
        nlohmann::json& kept_figures = figures[owners[i]->run.variant.name()];
        if (contenders[i].error.empty()) {
            kept_figures = stats_state(contenders[i].stats);
            owners[i]->keep(std::move(contenders[i].stats), stop, command.frame_limit, report.software());
        } else {
            kept_figures = contenders[i].error;
            owners[i]->fail(contenders[i].error, stop);
        }
    }
    kept.keep(step, std::move(figures));
    return rounds;
}

/// A result as it comes: what a frame of each costs.
void tell_times(const Stop& stop, const std::vector<Timed>& all, const Report& report) {
    std::string line;
    for (const Timed& timed : all) {
        const Stats& stats =
            timed.run.in_series && !timed.run.series.empty() ? timed.run.series.back() : timed.run.stats;
        if (timed.run.error.empty() && stats.lights == stop.total && stats.frames > 0)
            line += fmt::format("{}{} {:.1f} ms", line.empty() ? "" : ", ", timed.run.variant.name(),
                                (report.software() ? stats.cpu_ms : stats.gpu_ms).median);
    }
    if (!line.empty())
        tell(fmt::format("{} light{}: {}", stop.total, stop.total == 1 ? "" : "s", line));
}

} // namespace

const PlacedCamera& camera_of(const World& world, const std::string& name) {
    return name.empty() ? world.cameras.at(0) : find_camera(world, name);
}

void take_times(Report& report, Device& device, const SceneSeries& scenes, const World& world, KeptSteps& kept,
                Progress& progress, double share) {
    const std::vector<Stop> stops = make_stops(report, scenes);
    std::vector<Timed> all;
    for (RunReport& run : report.runs)
        all.push_back({run, nullptr});
    bool own_done = false;
    for (size_t i = 0; i < stops.size(); ++i) {
        if (!stops[i].own() && report.budget.left() <= 0) {
            report.cut.push_back(fmt::format("{} lights left out", stops[i].total));
            for (RunReport& run : report.runs)
                if (run.in_series && run.stopped.empty())
                    run.stopped = fmt::format("no {} lights: --budget {:g}", stops[i].total, *report.budget.seconds());
            continue;
        }
        const auto lights = stops[i].own() ? world.lights : scenes.lights(*stops[i].lights);
        const auto show = [&](double part, const std::string& what) {
            const double done = (static_cast<double>(i) + part) / static_cast<double>(stops.size());
            progress.show(share + (1 - share) * done, fmt::format("{} lights: {}", stops[i].total, what));
        };
        progress.step(share + (1 - share) * double(i) / double(stops.size()),
                      fmt::format("frames with {} light{}", stops[i].total, stops[i].total == 1 ? "" : "s"));
        const double most = std::max(report.budget.left(), 0.0) / double(stops.size() - i);
        const uint32_t rounds = time_at(stops[i], world, lights, report, all, device, kept, most, show);
        progress.clear();
        tell_times(stops[i], all, report);
        if (rounds < report.command.frames)
            report.cut.push_back(
                fmt::format("{} of {} frames at {} lights", rounds, report.command.frames, stops[i].total));
        own_done = own_done || stops[i].own();
        for (Timed& timed : all) // those that will not be asked again free their memory
            if (own_done && !(timed.run.in_series && timed.run.stopped.empty()))
                timed.renderer.reset();
    }
    for (RunReport& run : report.runs) // slow, but nothing was left to stop before
        if (report.cut.empty() && !run.series.empty() && run.series.back().lights == stops.back().total)
            run.stopped.clear();
}

} // namespace prelight::app
