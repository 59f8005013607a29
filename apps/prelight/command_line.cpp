#include "command_line.hpp"

#include "argument.hpp"
#include "bench_command.hpp"
#include "options/generated.hpp"
#include "options/given.hpp"
#include "options/help.hpp"
#include "picture_command.hpp"
#include "sequence/plan.hpp"

#include <platform/program/standard_streams.hpp>
#include <prelight/error.hpp>
#include <prelight/version.hpp>

namespace prelight::app {
namespace {

/// What goes with one scene only, and what several need.
void check_scenes(const RenderCommand& command) {
    const bool piped = is_standard_stream(command.scene);
    if (command.watch && (piped || !command.more_scenes.empty()))
        throw UsageError(fmt::format("--watch: goes with one scene in a file only, not {}",
                                     piped ? "standard input" : "with " + command.more_scenes.front() + " too"));
    if (command.more_scenes.empty())
        return;
    for (const std::filesystem::path& file : outputs_of(command))
        if (file.string().find("{name}") == std::string::npos)
            throw UsageError(fmt::format("{}: {} scenes need {{name}} in it, as in '{{name}}.png' ({}, {})",
                                         file.string(), command.more_scenes.size() + 1, command.scene,
                                         fmt::join(command.more_scenes, ", ")));
}

/// A preset draws as its source text does.
bool leaves_edges_open(const Given& given, const RenderCommand& command) {
    return !given.has("--msaa") && command.options.preset.empty() && !command.options.settings.contains("antialiasing");
}

RenderCommand parse_render(const Given& given) {
    RenderCommand command = parse_picture(given);
    command.frames = parse_count("--frames", given.text("--frames", "1"), 1);
    command.moment = parse_moment(given.text("--time"), command.animation);
    command.watch = given.has("--watch");
    if (leaves_edges_open(given, command))
        command.edges = Edges::samples;
    check_outputs(command);
    const std::vector<std::string>& scenes = given.all("SCENE");
    command.scene = scenes.front();
    command.more_scenes.assign(scenes.begin() + 1, scenes.end());
    check_scenes(command);
    command.quiet = command.quiet || is_standard_stream(command.output) || is_standard_stream(command.stats);
    const EnvironmentChoice& environment = command.environment;
    if (environment.see_through() && (lower_extension(command.output) == ".exr" || command.view != "final"))
        throw UsageError(fmt::format("--background {}: needs the final picture, as PNG", given.text("--background")));
    return command;
}

SequenceCommand parse_series(const Given& given) {
    SequenceCommand command{.render = parse_picture(given), .sequence = parse_sequence(given)};
    refuse_see_through(command.render.environment, given);
    if (leaves_edges_open(given, command.render))
        command.render.edges = Edges::filtered;
    check_sequence(command);
    return command;
}

ViewCommand parse_viewer(const Given& given) {
    ViewCommand command{.render = parse_picture(given), .record = given.text("--record"), .play = given.text("--play")};
    RenderCommand& render = command.render;
    refuse_see_through(render.environment, given);
    render.moment = parse_moment(given.text("--time"), render.animation);
    render.watch = given.has("--watch");
    if (!render.more_views.empty())
        throw UsageError("--view: view shows one buffer, and writes none to a file");
    render.options.views = {render.view};
    if (given.has("--frames"))
        command.steps = parse_count("--frames", given.text("--frames"), 1);
    const std::string scale = given.text("--scale", "1");
    if (scale != "auto")
        command.scale = parse_number("--scale", scale, 0.1, 1);
    if (command.play.empty() && (command.steps || !render.output.empty()))
        throw UsageError(fmt::format("{}: goes with --play FILE only", command.steps ? "--frames" : "-o"));
    if (!command.play.empty() && !command.record.empty())
        throw UsageError("--record: does not go with --play");
    if (!render.output.empty()) {
        check_endings(render, false);
        refuse_pattern("-o", render.output);
    }
    return command;
}

CompareCommand parse_compare(const Given& given, int argc, const char* const* argv) {
    CompareCommand command;
    for (int i = 1; i < argc; ++i)
        command.arguments += fmt::format("{}\n", argv[i]);
    command.quiet = given.has("--quiet");
    command.scene = given.text("SCENE");
    command.folder = given.text("--output");
    command.camera = given.text("--camera");
    command.animation = given.text("--animation");
    command.device = given.text("--device", command.device);
    command.validate = given.has("--validate");
    std::tie(command.options.width, command.options.height) = parse_size("--size", given.text("--size", "960x540"));
    command.options.msaa = parse_count("--msaa", given.text("--msaa", "1"), 1);
    if (given.has("--shading"))
        command.options.shading = parse_shading(given.text("--shading"));
    command.exposure = take_exposure(given, command.options);
    command.frames = parse_count("--frames", given.text("--frames", "5"), 1);
    command.moment = parse_moment(given.text("--time"), command.animation);
    command.seed = parse_seed("--seed", given.text("--seed", "1"));
    if (given.has("--lights"))
        command.lights = parse_count("--lights", given.text("--lights"), 1);
    if (given.has("--renderers"))
        command.variants = parse_variants("--renderers", given.text("--renderers"));
    command.environment = parse_environment(given);
    refuse_see_through(command.environment, given);
    command.reading = parse_reading(given);
    command.framing = parse_view(given);
    command.light_counts =
        parse_light_counts("--light-counts", given.text("--light-counts", "1,4,16,64,256,1024,4096"));
    command.frame_limit = parse_number("--frame-limit", given.text("--frame-limit", "1"), 0, 1e6);
    if (given.has("--budget"))
        command.budget = parse_number("--budget", given.text("--budget"), 0.001, 1e9);
    return command;
}

MakeCommand parse_make(const Given& given) {
    MakeCommand command{.quiet = given.has("--quiet"), .scene = given.text("NAME"), .output = given.text("--output")};
    if (lower_extension(command.output) != ".glb")
        throw UsageError("-o " + command.output.string() + ": the name must end in .glb");
    command.seed = parse_seed("--seed", given.text("--seed", "1"));
    if (given.has("--lights"))
        command.lights = parse_count("--lights", given.text("--lights"), 1);
    return command;
}

InfoCommand parse_info(const Given& given) {
    InfoCommand command{.scene = given.text("SCENE"), .reading = parse_reading(given), .json = given.has("--json")};
    command.seed = parse_seed("--seed", given.text("--seed", "1"));
    if (given.has("--lights"))
        command.lights = parse_count("--lights", given.text("--lights"), 1);
    return command;
}

PrintCommand parse_help(const Given& given) {
    return {topic_help(fmt::format("{}", fmt::join(given.all("TOPIC"), " ")))};
}

const CommandRow& command_of(const std::string& name) {
    if (const CommandRow* command = find_command(name))
        return *command;
    const std::vector<std::string> known = command_names();
    throw UsageError(fmt::format("{}: not a command ({}){}", name, fmt::join(known, ", "), did_you_mean(name, known)));
}

} // namespace

Command parse_command_line(int argc, const char* const* argv) {
    if (argc < 2)
        throw UsageError("no command (see prelight --help)");
    const std::string first = argv[1];
    if (first == "-h" || first == "--help")
        return PrintCommand{program_help()};
    if (first == "--version")
        return PrintCommand{"prelight " + std::string(version()) + "\n"};
    if (first.starts_with('-'))
        throw UsageError(fmt::format("{}: the command comes first{} (see prelight --help)", first,
                                     did_you_mean(first, {"--help", "--version"})));
    const CommandRow& row = command_of(first);
    // `help --exposure` asks about an option.
    if (row.bits == command_bit::help && argc == 3 && argv[2][0] == '-' && std::string_view(argv[2]) != "--help")
        return PrintCommand{topic_help(argv[2])};
    const std::optional<Given> given = parse_arguments(row, {argv + 2, argv + argc});
    if (!given)
        return PrintCommand{command_help(row)};
    switch (row.bits) {
    case command_bit::render: return parse_render(*given);
    case command_bit::sequence: return parse_series(*given);
    case command_bit::view: return parse_viewer(*given);
    case command_bit::compare: return parse_compare(*given, argc, argv);
    case command_bit::bench: return parse_bench(*given);
    case command_bit::make: return parse_make(*given);
    case command_bit::info: return parse_info(*given);
    case command_bit::renderers: return RenderersCommand{given->text("NAME")};
    case command_bit::materials: return MaterialsCommand{given->text("NAME")};
    case command_bit::completions: return PrintCommand{completion_script(given->text("SHELL"))};
    case command_bit::man: return PrintCommand{man_page(given->text("COMMAND"))};
    case command_bit::help: return parse_help(*given);
    default: return DevicesCommand{};
    }
}

bool wants_quiet(const Command& command) {
    return std::visit(
        [](const auto& one) {
            if constexpr (requires { one.quiet; })
                return one.quiet;
            else if constexpr (requires { one.render.quiet; })
                return one.render.quiet;
            else
                return false;
        },
        command);
}

} // namespace prelight::app
