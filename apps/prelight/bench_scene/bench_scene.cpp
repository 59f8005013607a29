// `prelight bench SCENE`: contenders in turn at each number of lights, with the limits of the device.
#include "bench_scene.hpp"

#include "baseline.hpp"
#include "bench_json.hpp"
#include "device_type.hpp"
#include "memory_check.hpp"
#include "output.hpp"
#include "scene_files.hpp"
#include "stats_json.hpp"
#include "table.hpp"
#include "time_budget.hpp"
#include "validation.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <platform/program/standard_streams.hpp>
#include <prelight/error.hpp>
#include <prelight/version.hpp>

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint32_t default_frames = 9;

std::vector<Stop> stops_of(const BenchCommand& command, const SceneSeries& scenes) {
    std::vector<Stop> stops;
    for (const uint32_t count : command.light_counts)
        stops.push_back({count, scenes.total(count)});
    if (stops.empty())
        stops.push_back({command.lights, scenes.make()->world.lights.size()});
    return stops;
}

/// Before any work, what would fail after it.
void check_light_counts(const std::vector<Job>& jobs, const std::vector<Stop>& stops, Device& device) {
    for (const Job& job : jobs) {
        const uint64_t most = create_renderer(job.variant.renderer, &device, job.options)->max_lights();
        if (stops.back().lights > most)
            throw Error(fmt::format("{}: {} lights: this device holds {}", job.name(), stops.back().lights, most));
    }
}

/// What of the frames and numbers of lights that were asked for there was no time for.
Json budget_json(const BenchCommand& command, const TimeBudget& budget, const Measured& measured) {
    if (!budget.seconds())
        return nullptr;
    Json frames = Json::array(), left_out = Json::array();
    for (const auto& [stop, count] : measured.frames)
        frames.push_back({{"lights", stop.lights}, {"frames", count}});
    for (const Stop& stop : measured.left_out)
        left_out.push_back(stop.lights);
    return {{"seconds", *budget.seconds()},
            {"spent_seconds", budget.spent()},
            {"frames_asked_for", *command.frames},
            {"frames", frames},
            {"lights_left_out", left_out}};
}

/// The same as a line; empty: nothing was cut.
std::string cut_line(const BenchCommand& command, const TimeBudget& budget, const Measured& measured) {
    if (!budget.seconds())
        return {};
    std::string cut;
    for (const auto& [stop, count] : measured.frames)
        if (count < *command.frames)
            cut += fmt::format("{}{} of {} frames at {} light{}", cut.empty() ? "" : ", ", count, *command.frames,
                               stop.lights, stop.lights == 1 ? "" : "s");
    for (const Stop& stop : measured.left_out)
        cut += fmt::format("{}{} lights left out", cut.empty() ? "" : ", ", stop.lights);
    return cut.empty() ? cut : fmt::format("--budget {:g}: {}", *budget.seconds(), cut);
}

Json heading(const BenchCommand& command, const Device& device, const std::string& type, const Measured& measured) {
    return {{"prelight_bench", 1},
            {"version", version()},
            {"device", device.name()},
            {"driver", device.driver()},
            {"device_type", type},
            {"scene", command.scene},
            {"camera", measured.camera},
            {"seed", command.seed},
            {"time", command.moment ? Json(command.moment->time) : Json(nullptr)},
            {"size", {command.options.width, command.options.height}},
            {"shading", command.options.shading.value_or(Shading::ggx) == Shading::ggx ? "ggx" : "phong"},
            {"triangles", measured.triangles},
            {"frames", *command.frames},
            {"steady_time", type == "software" ? "cpu_ms" : "gpu_ms"}};
}

} // namespace

void bench_scene(const BenchCommand& given) {
    const TimeBudget budget(given.budget);
    BenchCommand command = given;
    command.frames = given.frames.value_or(default_frames);
    std::vector<std::filesystem::path> inputs = files_named_in(command.scene);
    inputs.insert(inputs.end(), {command.scene, command.baseline, command.environment.file});
    check_distinct(std::array{command.json}, inputs);
    if (!command.json.empty())
        check_writable(command.json);
    const std::optional<SavedBench> baseline =
        command.baseline.empty() ? std::nullopt : std::optional(load_bench(command.baseline));
    const std::vector<Job> contenders = contenders_of(command);
    std::vector<Job> jobs = contenders;
    std::vector<std::string> missing;
    if (command.limit)
        for (Job& job : limit_jobs(contenders, command, missing))
            jobs.push_back(std::move(job));

    const auto device = open_device({.select = command.device, .validate = command.validate}, command.options.width,
                                    command.options.height, command.options.msaa);
    const std::string type = type_of(*device);
    const bool software = type == "software";
    const SceneSeries scenes(command.scene, command.lights, command.seed,
                             {command.moment, command.animation, command.reading},
                             environment_edit(command.environment),
                             {double(command.options.width) / command.options.height, command.framing});
    const std::vector<Stop> stops = stops_of(command, scenes);
    check_light_counts(jobs, stops, *device);
    // The table is what was asked for, unless a file was.
    const bool piped = is_standard_stream(command.json);
    const bool prints = !piped && (!is_quiet() || command.json.empty());
    size_t printed = 0;
    const auto figures = [&](const Measured& so_far, bool complete) {
        std::vector<std::string> lacking = missing;
        lacking.insert(lacking.end(), so_far.missing.begin(), so_far.missing.end());
        const std::vector<LimitFigures> limits = limit_figures(so_far, jobs, software, lacking);
        if (prints && printed == 0)
            fmt::print("{}, {}x{}, {} triangles, {} frames of each in turn, on {}\n", command.scene,
                       command.options.width, command.options.height, so_far.triangles, *command.frames,
                       device->name());
        for (; prints && printed < so_far.frames.size(); ++printed) {
            print_runs(so_far, so_far.frames[printed].first, limits);
            print_limits(so_far.frames[printed].first, limits);
        }
        Json json = heading(command, *device, type, so_far);
        json["complete"] = complete;
        json["budget"] = budget_json(command, budget, so_far);
        json["runs"] = Json::array();
        for (const Run& run : so_far.runs)
            if (run.job->role == Role::contender)
                json["runs"].push_back(run_json(command.scene, run));
        if (command.limit)
            json["limit"] = limit_json(command.scene, so_far, limits, lacking);
        for (const std::string& line : lacking)
            if (prints && complete)
                fmt::print("not measured: {}\n", line);
        return json;
    };
    // What is measured is kept, whatever ends the command.
    const auto keep = [&](const Measured& so_far) {
        const Json json = figures(so_far, false);
        if (!command.json.empty() && !piped)
            save_text(json_text(json), command.json);
    };
    const Measured measured = measure(jobs, stops, scenes, command, *device, software, budget, keep);
    check_validation(*device);
    Json json = figures(measured, true);
    if (const std::string cut = cut_line(command, budget, measured); prints && !cut.empty())
        fmt::print("{}\n", cut);
    if (baseline)
        json["baseline"] = print_changes(*baseline, saved_bench(json, "this run"), command.baseline.string());
    if (!command.json.empty())
        save_text(json_text(json), command.json);
}

} // namespace prelight::app
