#include "bench_command.hpp"

#include "argument.hpp"
#include "bench.hpp"
#include "options/given.hpp"
#include "picture_command.hpp"
#include "scene_source.hpp"

#include <platform/program/standard_streams.hpp>

namespace prelight::app {
namespace {

using Kind = BenchCommand::Kind;

/// The command line names a table, `report`, or else a scene.
Kind kind_of(const std::string& what) {
    if (what == "report")
        return Kind::report;
    if (is_bench(what))
        return Kind::table;
    if (!names_file(what) && !names_builtin(what)) {
        std::vector<std::string> known = split_words(bench_names(), ',');
        for (std::string& name : known)
            name.erase(0, name.find_first_not_of(' '));
        known.emplace_back("report");
        for (const std::string& name : builtin_list())
            known.push_back(name);
        throw UsageError(fmt::format("{}: neither a scene ({}, or a file) nor a bench ({}, report){}", what,
                                     builtin_names(), bench_names(), did_you_mean(what, known)));
    }
    return Kind::scene;
}

void check_kind(const Given& given, Kind kind) {
    namespace bit = command_bit;
    if (given.has("FILE") && kind != Kind::report)
        throw UsageError(fmt::format("{}: a FILE goes with bench report only", given.text("FILE")));
    given.check_bit(kind == Kind::scene   ? bit::bench_scene
                    : kind == Kind::table ? bit::bench_table
                                          : bit::bench_report,
                    {{bit::bench_scene, "bench SCENE"},
                     {bit::bench_table, "bench of a table"},
                     {bit::bench_report, "bench report"},
                     {bit::figures, "bench SCENE or of a table"}});
}

void take_scene(const Given& given, BenchCommand& command) {
    command.scene = command.what;
    if (given.has("--size"))
        std::tie(command.options.width, command.options.height) = parse_size("--size", given.text("--size"));
    if (given.has("--msaa"))
        command.options.msaa = parse_count("--msaa", given.text("--msaa"), 1);
    if (given.has("--shading"))
        command.options.shading = parse_shading(given.text("--shading"));
    take_settings(given, nullptr, command.options.settings);
    if (given.has("--renderers"))
        command.variants = parse_variants("--renderers", given.text("--renderers"));
    if (given.has("--light-counts"))
        command.light_counts = parse_light_counts("--light-counts", given.text("--light-counts"));
    if (!command.light_counts.empty() && command.lights)
        throw UsageError("--lights: goes without --light-counts only");
    command.animation = given.text("--animation");
    command.moment = parse_moment(given.text("--time"), command.animation);
    command.environment = parse_environment(given);
    refuse_see_through(command.environment, given);
    command.reading = parse_reading(given);
    command.limit = given.has("--limit");
    if (given.has("--budget"))
        command.budget = parse_number("--budget", given.text("--budget"), 0.001, 1e9);
    command.baseline = given.text("--baseline");
}

void take_report(const Given& given, BenchCommand& command) {
    const std::vector<std::string>& files = given.all("FILE");
    command.files.assign(files.begin(), files.end());
    command.output = given.text("--output");
    if (files.empty())
        throw UsageError("bench report: names no file of figures");
    if (lower_extension(command.output) != ".html")
        throw UsageError(fmt::format("-o {}: the page's name must end in .html",
                                     command.output.empty() ? "\"\"" : command.output.string()));
}

} // namespace

BenchCommand parse_bench(const Given& given) {
    BenchCommand command;
    command.what = given.text("WHAT");
    command.kind = kind_of(command.what);
    command.quiet = given.has("--quiet");
    check_kind(given, command.kind);
    command.camera = given.text("--camera");
    command.framing = parse_view(given);
    command.device = given.text("--device", command.device);
    command.validate = given.has("--validate");
    command.seed = parse_seed("--seed", given.text("--seed", "1"));
    command.json = given.text("--json");
    if (given.has("--lights"))
        command.lights = parse_count("--lights", given.text("--lights"), 1);
    if (given.has("--frames"))
        command.frames = parse_count("--frames", given.text("--frames"), 1);
    if (command.kind == Kind::scene)
        take_scene(given, command);
    if (command.kind == Kind::report)
        take_report(given, command);
    if (command.kind == Kind::table) {
        if (is_standard_stream(command.json))
            throw UsageError("--json -: the table goes to standard output");
        if (given.has("--size"))
            std::tie(command.width, command.height) = parse_size("--size", given.text("--size"));
        command.scene = given.text("--scene", command.scene);
    }
    return command;
}

} // namespace prelight::app
