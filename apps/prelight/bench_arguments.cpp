#include "bench_arguments.hpp"

#include "argument.hpp"
#include "bench.hpp"
#include "scene_source.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>

namespace prelight::app {
namespace {

using Kind = BenchCommand::Kind;

constexpr const char* footer = R"(Examples:
  prelight bench lights --light-counts 16,256,4096 --limit --json lights.json
  prelight bench city --renderers light-prepass,deferred@light-culling=tiles --frames 5
  prelight bench lights --light-counts 16,256,4096 --limit --baseline lights.json
  prelight bench report lights.json -o lights.html
  prelight bench encodings --json encodings.json
Tables of their own: )";

/// The command line names a table, `report`, or else a scene.
Kind kind_of(const std::string& what) {
    if (what == "report")
        return Kind::report;
    if (is_bench(what))
        return Kind::table;
    const auto scenes = builtin_scenes();
    if (!names_file(what) && std::ranges::find(scenes, std::string_view(what), &BuiltinScene::name) == scenes.end())
        throw UsageError(fmt::format("{}: neither a scene ({}, or a file) nor a bench ({}, report)", what,
                                     builtin_names(), bench_names()));
    return Kind::scene;
}

} // namespace

void BenchArguments::add(CLI::App& app) {
    auto& sub = *app.add_subcommand("bench", "Measure, and print a table");
    const auto option = [&](const char* names, auto& target, const char* word, const char* help) {
        return sub.add_option(names, target, help)->type_name(word)->allow_extra_args(false);
    };
    sub.footer(footer + bench_names() + ".");
    sub.add_option("WHAT", what_, "A .gltf or .glb file or built-in scene to time, a table below, or report")
        ->required()
        ->type_name("");
    sub.add_option("FILE", files_, "report: files of --json, side by side")->type_name("");
    option("--renderers", renderers_, "LIST",
           "Scene: what to time, as in a,b@KEY=VALUE,c@preset=NAME (default light-prepass,deferred)");
    option("--light-counts", light_counts_, "LIST", "Scene: numbers of lights, as in 16,256,4096 (default its own)");
    sub.add_flag("--limit", limit_, "Scene: measure what the device could do, and give frames in units of F");
    option("--baseline", baseline_, "FILE", "Scene: print the change since a file of --json");
    option("--set", settings_, "KEY=VALUE", "Scene: a setting of every renderer that has it; repeatable");
    option("--shading", shading_, "MODEL", "Scene: ggx or phong (default: each preset's, else ggx)");
    option("--time", time_, "SECONDS", "Scene: moment of its animations (default: at rest)");
    option("--animation", animation_, "NAME|INDEX", "Scene: only this animation, at --time or else at 0 s");
    add_environment_options(option, environment_);
    add_file_options(sub, option, reading_);
    add_view_options(option, view_);
    sub.add_flag("--count-pairs", count_pairs_,
                 "Scene: light x pixel pairs are always counted, in a frame that is not timed");
    option("-o,--output", output_, "PAGE", "report: the page to write, .html");
    option("--frames", frames_, "N", "Frames of each way to time, interleaved (default 9; claims 5)");
    option("--json", json_, "FILE", "Write the figures as JSON too");
    option("--scene", table_scene_, "SCENE",
           "Tables: file or built-in scene (default spheres). Scene: which of the file's scenes, NAME|INDEX");
    option("--camera", camera_, "NAME|INDEX", "Camera of the scene (default the first)");
    option("--size", size_, "WxH", "Picture size in pixels (default 1280x720; a table has its own)");
    option("--msaa", msaa_, "N", "Scene: samples per pixel (default 1)");
    option("--lights", lights_, "N", "Light count of a built-in scene; adds N random point lights to any other");
    option("--seed", seed_, "S", "Seed of what is random (default 1)");
    option("--device", device_, "DEVICE", "auto (default), cpu, an index or a name");
    sub.add_flag("--validate", validate_, "Run with Vulkan validation; any message is a failure");
}

void BenchArguments::check_kind(Kind kind) const {
    struct Given {
        const char* option;
        bool given;
        std::vector<Kind> kinds;
    };
    const std::vector<Kind> scene{Kind::scene}, table{Kind::table}, report{Kind::report},
        both{Kind::scene, Kind::table};
    for (const Given& one : {Given{"FILE", !files_.empty(), report},
                             {"-o", !output_.empty(), report},
                             {"--renderers", !renderers_.empty(), scene},
                             {"--light-counts", !light_counts_.empty(), scene},
                             {"--limit", limit_, scene},
                             {"--baseline", !baseline_.empty(), scene},
                             {"--set", !settings_.empty(), scene},
                             {"--shading", !shading_.empty(), scene},
                             {"--time", !time_.empty(), scene},
                             {"--msaa", !msaa_.empty(), scene},
                             {"--animation", !animation_.empty(), scene},
                             {"--environment", !environment_.file.empty(), scene},
                             {"--environment-intensity", !environment_.intensity.empty(), scene},
                             {"--environment-rotation", !environment_.rotation.empty(), scene},
                             {"--background", !environment_.background.empty(), scene},
                             {"--view-from", !view_.from.empty(), scene},
                             {"--fit", !view_.fit.empty(), scene},
                             {"--count-pairs", count_pairs_, scene},
                             {"--strict", reading_.strict, scene},
                             {"--log-level", !reading_.log_level.empty(), scene},
                             {"--memory-limit", !reading_.memory_limit.empty(), scene},
                             {"--scene", !table_scene_.empty(), both},
                             {"--frames", !frames_.empty(), both},
                             {"--json", !json_.empty(), both},
                             {"--camera", !camera_.empty(), both},
                             {"--size", !size_.empty(), both},
                             {"--lights", !lights_.empty(), both},
                             {"--validate", validate_, both}})
        if (one.given && std::ranges::find(one.kinds, kind) == one.kinds.end())
            throw UsageError(fmt::format("{}: goes with bench {} only", one.option,
                                         one.kinds == scene    ? "SCENE"
                                         : one.kinds == table  ? "of a table"
                                         : one.kinds == report ? "report"
                                                               : "SCENE or of a table"));
}

void BenchArguments::take_scene(BenchCommand& command) const {
    command.scene = what_;
    if (!size_.empty())
        std::tie(command.options.width, command.options.height) = parse_size("--size", size_);
    if (!msaa_.empty())
        command.options.msaa = parse_count("--msaa", msaa_, 1);
    if (!shading_.empty())
        command.options.shading = parse_shading(shading_);
    for (const std::string& setting : settings_) {
        const auto [key, value] = parse_pair("--set", setting);
        command.options.settings[key] = value;
    }
    if (!renderers_.empty())
        command.variants = parse_variants("--renderers", renderers_);
    if (!light_counts_.empty())
        command.light_counts = parse_light_counts("--light-counts", light_counts_);
    if (!command.light_counts.empty() && command.lights)
        throw UsageError("--lights: goes without --light-counts only");
    command.moment = parse_moment(time_, animation_);
    command.animation = animation_;
    command.environment = parse_environment(environment_);
    command.reading = parse_reading(reading_);
    command.reading.scene = table_scene_;
    command.limit = limit_;
    command.baseline = baseline_;
}

BenchCommand BenchArguments::command() const {
    BenchCommand command{.kind = kind_of(what_), .what = what_};
    check_kind(command.kind);
    command.camera = camera_;
    command.framing = parse_view(view_, camera_);
    command.device = device_;
    command.validate = validate_;
    command.seed = parse_seed("--seed", seed_);
    command.json = json_;
    if (!lights_.empty())
        command.lights = parse_count("--lights", lights_, 1);
    if (!frames_.empty())
        command.frames = parse_count("--frames", frames_, 1);
    if (command.kind == Kind::scene)
        take_scene(command);
    if (command.kind == Kind::table) {
        if (!size_.empty())
            std::tie(command.width, command.height) = parse_size("--size", size_);
        if (!table_scene_.empty())
            command.scene = table_scene_;
    }
    if (command.kind == Kind::report) {
        command.files.assign(files_.begin(), files_.end());
        command.output = output_;
        if (files_.empty())
            throw UsageError("bench report: names no file of figures");
        if (lower_extension(command.output) != ".html")
            throw UsageError(
                fmt::format("-o {}: the page's name must end in .html", output_.empty() ? "\"\"" : output_));
    }
    return command;
}

} // namespace prelight::app
