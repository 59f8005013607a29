// `prelight compare`: every architecture on one scene, as a page that needs no server.
#include "commands.hpp"
#include "device_type.hpp"
#include "memory_check.hpp"
#include "output.hpp"
#include "page.hpp"
#include "pictures.hpp"
#include "renderer_info.hpp"
#include "scene_files.hpp"
#include "stats_json.hpp"
#include "times.hpp"
#include "validation.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <platform/program/standard_streams.hpp>
#include <prelight/device.hpp>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

constexpr double share_of_pictures = 0.4; ///< of the progress bar

std::vector<RunReport> make_runs(const CompareCommand& command) {
    const bool named = !command.variants.empty();
    std::vector<RunReport> runs;
    for (const Variant& variant : named ? command.variants : standard_variants(renderer_infos())) {
        RunReport run{.variant = variant, .info = find_renderer(variant.renderer)};
        run.options = command.options;
        run.options.preset = variant.preset;
        run.options.settings = variant.settings;
        // Presets differ in what they store, not in how their time grows: they stay out of the chart
        // unless somebody asks for them.
        run.in_series = named || variant.preset.empty();
        runs.push_back(std::move(run));
    }
    return runs;
}

std::vector<std::filesystem::path> inputs_of(const CompareCommand& command) {
    std::vector<std::filesystem::path> files = files_named_in(command.scene);
    if (is_standard_stream(command.scene))
        files.push_back(standard_input_file());
    else if (names_file(command.scene))
        files.emplace_back(command.scene);
    files.push_back(command.environment.file);
    return files;
}

/// All that decides what the steps come to: the same arguments, files, program and device.
std::string key_of(const Report& report) {
    const CompareCommand& command = report.command;
    std::string key = fmt::format("{}\n{}{}\n{}\n", command.arguments, program_key(), report.device, report.driver);
    for (const std::filesystem::path& file : inputs_of(command))
        key += content_key(file);
    return key;
}

/// One exposure and one environment for all, found by looking at the scene.
void take_sight(Report& report, Device& device, const World& world, SceneSeries& scenes) {
    const CompareCommand& command = report.command;
    RenderOptions& options = report.command.options;
    options.exposure = take_first_sight({.device = &device,
                                         .world = world,
                                         .camera = camera_of(world, command.camera),
                                         .options = options,
                                         .exposure = command.exposure,
                                         .environment = command.environment,
                                         .lit_file = names_file(command.scene) && scenes.added() == 0,
                                         .edit = [&](const SceneEdit& edit) { scenes.edit(edit); }})
                           .ev;
    for (RunReport& run : report.runs)
        run.options.exposure = options.exposure;
}

/// A result as it comes. What failed is told at the end.
void tell_picture(const RunReport& run) {
    const Comparison& d = run.difference;
    if (run.error.empty())
        tell(fmt::format("{}: {:.1f} dB from the reference, FLIP {:.4f}", run.variant.name(), d.psnr, d.flip));
}

void take_all_pictures(Report& report, Device& device, const World& world, ReportFolder& folder, KeptSteps& kept,
                       Progress& progress) {
    const PlacedCamera& camera = camera_of(world, report.command.camera);
    report.camera = camera.camera.name;
    PictureStore store(folder, kept);
    progress.step(0,
                  kept.found() ? fmt::format("{} finished steps of an earlier run found", kept.found()) : "reference");
    take_reference_pictures(report, world, camera, store, kept);
    References references(world, camera, report.command.options);
    for (size_t i = 0; i < report.runs.size(); ++i) {
        const double done = double(i + 1) / double(report.runs.size() + 1);
        progress.step(share_of_pictures * done, "picture of " + report.runs[i].variant.name());
        take_or_find_pictures(report.runs[i], device, world, camera, references, store, kept);
        progress.clear();
        tell_picture(report.runs[i]);
    }
}

/// A report without a single figure is no report.
void check_any(const Report& report) {
    for (const RunReport& run : report.runs)
        if (run.error.empty())
            return;
    const RunReport& first = report.runs.at(0);
    const std::string line =
        fmt::format("{}: nothing could be rendered: {}: {}", report.scene, first.variant.name(), first.error);
    if (std::ranges::all_of(report.runs, &RunReport::wrong_usage))
        throw UsageError(line);
    throw Error(line);
}

/// With what is to be forgotten once the report is in its place.
KeptSteps make_report(Report& report, ReportFolder& folder) {
    const CompareCommand& command = report.command;
    const auto device = open_device({.select = command.device, .validate = command.validate}, command.options.width,
                                    command.options.height, command.options.msaa);
    report.device = device->name();
    report.driver = device->driver();
    report.device_type = type_of(*device);
    SceneSeries scenes(command.scene, command.lights, command.seed,
                       {command.moment, command.animation, command.reading}, environment_edit(command.environment),
                       {double(command.options.width) / command.options.height, command.framing});
    KeptSteps kept(key_of(report));
    {
        Progress progress;
        const auto scene = scenes.make();
        report.lights = scene->world.lights.size();
        report.lights_added = scenes.added();
        report.triangles = scene->world.triangles;
        take_sight(report, *device, scene->world, scenes);
        take_all_pictures(report, *device, scene->world, folder, kept, progress);
        check_any(report);
        take_times(report, *device, scenes, scene->world, kept, progress, share_of_pictures);
        check_any(report);
    }
    check_validation(*device);
    return kept;
}

} // namespace

void run(const CompareCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    Report report{.command = command, .budget = TimeBudget(command.budget)};
    report.scene = names_file(command.scene) ? std::filesystem::path(command.scene).filename().string() : command.scene;
    report.runs = make_runs(command);
    check_scene_name(command.scene);
    check_outside(command.folder, inputs_of(command));
    ReportFolder folder(command.folder);
    KeptSteps kept = make_report(report, folder);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    const nlohmann::ordered_json json = report_json(report);
    folder.write([&](const std::filesystem::path& path) {
        save_text(json_text(json), path / "report.json");
        save_text(fill_page(report_page, json), path / "index.html");
    });
    folder.publish();
    kept.forget();
    for (const std::string& line : report.cut)
        tell(fmt::format("--budget {:g}: {}", *report.budget.seconds(), line));
    const auto failed = std::ranges::count_if(report.runs, [](const RunReport& run) { return !run.error.empty(); });
    tell(fmt::format("{}: {}, rendered in {} way(s){}, {} light(s), {:.0f} s on {}",
                     (command.folder / "index.html").string(), report.scene, report.runs.size() - size_t(failed),
                     failed ? fmt::format(", {} failed", failed) : "", report.lights, report.seconds, report.device));
}

} // namespace prelight::app
