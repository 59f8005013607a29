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
#include "validation.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
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
    const Measured measured = measure(jobs, stops, scenes, command, *device, software);
    check_validation(*device);
    missing.insert(missing.end(), measured.missing.begin(), measured.missing.end());
    const std::vector<LimitFigures> limits = limit_figures(measured, jobs, software, missing);

    if (!is_quiet() || command.json.empty()) { // the table is what was asked for, unless a file was
        fmt::print("{}, {}x{}, {} triangles, {} frames of each in turn, on {}\n", command.scene, command.options.width,
                   command.options.height, measured.triangles, *command.frames, device->name());
        print_runs(measured, limits);
        print_limits(limits, missing);
    }

    Json json = heading(command, *device, type, measured);
    json["runs"] = Json::array();
    for (const Run& run : measured.runs)
        if (run.job->role == Role::contender)
            json["runs"].push_back(run_json(command.scene, run));
    if (command.limit)
        json["limit"] = limit_json(command.scene, measured, limits, missing);
    if (baseline)
        json["baseline"] = print_changes(*baseline, saved_bench(json, "this run"), command.baseline.string());
    if (!command.json.empty())
        save_text(json_text(json), command.json);
}

} // namespace prelight::app
