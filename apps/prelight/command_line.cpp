// This, picture_arguments.cpp and bench_arguments.cpp are the only units that include CLI11: it takes seconds to
// compile.
#include "command_line.hpp"

#include "argument.hpp"
#include "bench_arguments.hpp"
#include "picture_arguments.hpp"
#include "sequence/plan.hpp"

#include <CLI/CLI.hpp>
#include <prelight/error.hpp>
#include <prelight/version.hpp>

namespace prelight::app {
namespace {

constexpr const char* program_footer = R"(Examples:
  prelight render city --lights 1024 -o night.png
  prelight render helmet.glb --camera 1 --size 1920x1080 -o helmet.exr
  prelight sequence fox.glb -o fox.####.png
  prelight view city
  prelight compare city -o report
  prelight make spheres -o spheres.glb
  prelight renderers light-prepass
  prelight bench city --light-counts 64,1024 --limit --json city.json
Exit status: 0 done, 1 the work failed, 2 wrong usage.)";

constexpr const char* render_footer = R"(Examples:
  prelight render city --lights 4096 --seed 7 -o city.png --stats city.json
  prelight render helmet.glb --set normals=oct32 --shading phong -o helmet.png
  prelight render city -o city.png --view normal=normal.png --view depth=depth.png
  prelight render fox.glb --animation Run --time 0.4 -o fox.png
  prelight render city --view diffuse-light -o light.png
  prelight render helmet.glb --environment sky.hdr --environment-rotation 90 -o helmet.png
  prelight render helmet.glb --view-from 0,90 --fit 0.95 --exposure auto -o above.png
  prelight render helmet.glb --material Visor=toon.glsl -o helmet.png --watch
  prelight render city --renderer reference --size 320x180 -o truth.exr
A name ending in .exr receives exposed scene-linear values, without tone mapping.
`prelight renderers NAME` lists what --set, --view and --preset accept.)";

constexpr const char* sequence_footer = R"(Examples:
  prelight sequence fox.glb --animation Run -o run.####.png
  prelight sequence helmet.glb --turntable 10 -o helmet.mp4
  prelight sequence city --turntable 4 --fps 24 --frames-at 0-95x8 --size 640x360 -o city.####.png
  prelight sequence fox.glb --shard 2/6 --skip-existing -o run.####.png
Frame f shows the time f/F seconds, whatever was drawn before it. Without --frames-at: the animations
up to their last keyframe, or one round of the turntable. docs/sequences.md has more.)";

constexpr const char* view_footer = R"(Examples:
  prelight view city --lights 4096
  prelight view helmet.glb --environment sky.hdr --scale auto
  prelight view motion --record session.txt
  prelight view motion --play session.txt -o picture.png
Keys: ? lists them. docs/view.md has the rest.)";

constexpr const char* compare_footer = R"(Examples:
  prelight compare city -o report
  prelight compare scene.glb --lights 500 --size 640x360 -o report
  prelight compare city --renderers light-prepass,multipass@lights-per-pass=8 -o report
  prelight compare city --light-counts 16,256 --frames 3 -o report
Writes FOLDER/index.html, which opens from disk, FOLDER/report.json and FOLDER/pictures. An earlier
report in FOLDER is replaced; a folder with other files is refused.)";

struct ViewerText {
    RenderText render;
    std::string frames, scale = "1";
};

struct CompareText {
    std::string size = "960x540", msaa = "1", shading, output, lights, time, seed = "1", frames = "5";
    std::string exposure = "0", renderers, light_counts = "1,4,16,64,256,1024,4096", frame_limit = "1";
    EnvironmentText environment;
    SceneReadingText reading;
    ViewText view;
};

struct MakeText {
    std::string output, lights, seed = "1";
};

void add_render(CLI::App& app, RenderCommand& command, RenderText& text) {
    auto& sub = *app.add_subcommand("render", "Render a scene into a picture");
    const auto option = options_of(sub);
    sub.footer(render_footer);
    add_picture_options(sub, command, text);
    add_file_options(sub, command, text);
    add_moment_options(sub, command, text);
    option("-o,--output", text.output, "IMAGE", "The picture: PNG, or EXR when the name ends so")->required();
    option("--frames", text.frames, "N", "Frames to render and time (default 1)");
    sub.add_flag("--watch", command.watch, "Render again whenever the scene or a material file changes");
}

void add_sequence(CLI::App& app, SequenceCommand& command, RenderText& picture, SequenceText& text) {
    auto& sub = *app.add_subcommand("sequence", "Render many moments: numbered pictures, or a video");
    const auto option = options_of(sub);
    sub.footer(sequence_footer);
    add_picture_options(sub, command.render, picture);
    add_file_options(sub, command.render, picture);
    option("-o,--output", picture.output, "FILES",
           "Numbered pictures, as in out.####.png or out.####.exr; or a video: out.mp4, out.mkv")
        ->required();
    option("--animation", command.render.animation, "NAME|INDEX", "Only this animation of the scene (default all)");
    add_sequence_options(sub, option, text, command.sequence);
}

void add_view(CLI::App& app, ViewCommand& command, ViewerText& text) {
    auto& sub = *app.add_subcommand("view", "Show a scene in a window");
    const auto option = options_of(sub);
    add_picture_options(sub, command.render, text.render);
    add_moment_options(sub, command.render, text.render);
    sub.footer(view_footer);
    option("--view", text.render.views, "BUFFER", "Show this buffer in place of the picture");
    option("--scale", text.scale, "FACTOR|auto",
           "Pixels drawn for one of the window's, along each side, 0.1 to 1; auto: what keeps it fluent (default 1)");
    option("--record", command.record, "FILE", "Write all input to FILE");
    option("--play", command.play, "FILE", "Input from FILE; with -o without any window");
    option("--frames", text.frames, "N", "How many steps of 1/60 s to play (default: up to the last event)");
    option("-o,--output", text.render.output, "PICTURE", "What is seen at the end of --play: PNG or EXR");
    sub.add_flag("--watch", command.render.watch, "What view does anyway: files that change are read again");
}

void add_compare(CLI::App& app, CompareCommand& command, CompareText& text) {
    auto& sub = *app.add_subcommand("compare", "Show every architecture side by side as a web page");
    const auto option = options_of(sub);
    sub.footer(compare_footer);
    sub.add_option("SCENE", command.scene, "A .gltf or .glb file, or a built-in scene: see `make`")
        ->required()
        ->type_name("");
    option("-o,--output", text.output, "FOLDER", "Where the report goes")->required();
    option("--renderers", text.renderers, "LIST",
           "Architectures with settings, as in a,b@KEY=VALUE,c@preset=NAME (default all)");
    option("--light-counts", text.light_counts, "LIST",
           "Numbers of lights of the chart (default 1,4,16,64,256,1024,4096), or none");
    option("--frame-limit", text.frame_limit, "SECONDS",
           "A slower frame ends a variant's line in the chart (default 1)");
    option("--frames", text.frames, "N", "Frames of each variant to time, interleaved (default 5)");
    add_environment_options(option, text.environment);
    add_reading_options(sub, option, text.reading);
    add_view_options(option, text.view);
    option("--size", text.size, "WxH", "Picture size in pixels (default 960x540)");
    option("--msaa", text.msaa, "N", "Samples per pixel (default 1)");
    option("--camera", command.camera, "NAME|INDEX", "Camera of the scene (default the first)");
    option("--time", text.time, "SECONDS", "Moment of the scene's animations (default: at rest)");
    option("--animation", command.animation, "NAME|INDEX",
           "Only this animation of the scene (default all), at --time or else at 0 s");
    option("--lights", text.lights, "N", "Light count of a built-in scene; adds N random point lights to any other");
    option("--seed", text.seed, "S", "Seed of what is random (default 1)");
    option("--shading", text.shading, "MODEL", "ggx or phong (default: the preset's, else ggx)");
    option("--exposure", text.exposure, "EV|auto",
           "Multiplies light by 2^EV (default 0); auto: what suits the picture");
    option("--device", command.device, "DEVICE", "auto (default), cpu, an index or a name");
    sub.add_flag("--validate", command.validate, "Run with Vulkan validation; any message is a failure");
}

void add_make(CLI::App& app, MakeCommand& command, MakeText& text) {
    auto& sub = *app.add_subcommand("make", "Write a built-in scene as glTF");
    sub.footer("Example:\n  prelight make city --lights 256 --seed 3 -o city.glb\n"
               "Built-in scenes: " +
               builtin_names() + ".");
    sub.add_option("NAME", command.scene, "A built-in scene")->required()->type_name("");
    sub.add_option("-o,--output", text.output, "The file to write")->required()->type_name("GLB");
    sub.add_option("--lights", text.lights, "Number of lights, 1 to 65536")->type_name("N");
    sub.add_option("--seed", text.seed, "Seed of what is random (default 1)")->type_name("S");
}

void finish(RenderCommand& command, const RenderText& text) {
    finish_picture(command, text);
    command.frames = parse_count("--frames", text.frames, 1);
    command.moment = parse_moment(text.time, command.animation);
    command.smooth_edges =
        text.msaa.empty() && command.options.preset.empty() && !command.options.settings.contains("antialiasing");
    check_outputs(command);
}

void finish(SequenceCommand& command, const RenderText& picture, const SequenceText& text) {
    finish_picture(command.render, picture);
    finish(command.sequence, text);
    check_sequence(command);
}

void finish(ViewCommand& command, const ViewerText& text) {
    finish_picture(command.render, text.render);
    command.render.moment = parse_moment(text.render.time, command.render.animation);
    if (!command.render.more_views.empty())
        throw UsageError("--view: view shows one buffer, and writes none to a file");
    command.render.options.views = {command.render.view};
    if (!text.frames.empty())
        command.steps = parse_count("--frames", text.frames, 1);
    if (text.scale != "auto")
        command.scale = parse_number("--scale", text.scale, 0.1, 1);
    if (command.play.empty() && (command.steps || !command.render.output.empty()))
        throw UsageError(fmt::format("{}: goes with --play FILE only", command.steps ? "--frames" : "-o"));
    if (!command.play.empty() && !command.record.empty())
        throw UsageError("--record: does not go with --play");
    if (!command.render.output.empty()) {
        check_endings(command.render, false);
        refuse_pattern("-o", command.render.output);
    }
}

void finish(CompareCommand& command, const CompareText& text) {
    command.folder = text.output;
    std::tie(command.options.width, command.options.height) = parse_size("--size", text.size);
    command.options.msaa = parse_count("--msaa", text.msaa, 1);
    if (!text.shading.empty())
        command.options.shading = parse_shading(text.shading);
    take_exposure(command, text.exposure);
    command.frames = parse_count("--frames", text.frames, 1);
    command.moment = parse_moment(text.time, command.animation);
    command.seed = parse_seed("--seed", text.seed);
    if (!text.lights.empty())
        command.lights = parse_count("--lights", text.lights, 1);
    if (!text.renderers.empty())
        command.variants = parse_variants("--renderers", text.renderers);
    command.environment = parse_environment(text.environment);
    command.reading = parse_reading(text.reading);
    command.framing = parse_view(text.view, command.camera);
    command.light_counts = parse_light_counts("--light-counts", text.light_counts);
    command.frame_limit = parse_number("--frame-limit", text.frame_limit, 0, 1e6);
}

void finish(MakeCommand& command, const MakeText& text) {
    command.output = text.output;
    if (lower_extension(command.output) != ".glb")
        throw UsageError("-o " + text.output + ": the name must end in .glb");
    command.seed = parse_seed("--seed", text.seed);
    if (!text.lights.empty())
        command.lights = parse_count("--lights", text.lights, 1);
}

/// CLI11 would only say that a command is missing, not that this one is unknown.
void check_command(CLI::App& app, int argc, const char* const* argv) {
    if (argc < 2 || argv[1][0] == '-')
        return;
    std::string known;
    for (const CLI::App* sub : app.get_subcommands(nullptr)) {
        if (sub->get_name() == argv[1])
            return;
        known += (known.empty() ? "" : ", ") + sub->get_name();
    }
    throw UsageError(fmt::format("{}: not a command ({})", argv[1], known));
}

} // namespace

Command parse_command_line(int argc, const char* const* argv) {
    CLI::App app("Prelight renders scenes with very many dynamic lights.", "prelight");
    app.set_version_flag("--version", "prelight " + std::string(version()));
    app.require_subcommand(1);
    app.footer(program_footer);

    RenderCommand render;
    RenderText render_text;
    SequenceCommand sequence;
    RenderText sequence_picture;
    SequenceText sequence_text;
    ViewCommand view;
    ViewerText view_text;
    CompareCommand compare;
    CompareText compare_text;
    MakeCommand make;
    MakeText make_text;
    RenderersCommand renderers;
    MaterialsCommand materials;
    BenchArguments bench;
    add_render(app, render, render_text);
    add_sequence(app, sequence, sequence_picture, sequence_text);
    add_view(app, view, view_text);
    add_compare(app, compare, compare_text);
    add_make(app, make, make_text);
    bench.add(app);
    app.add_subcommand("devices", "Show the Vulkan devices and which would be taken");
    auto& list = *app.add_subcommand("renderers", "List renderers, or what one of them can do");
    list.add_option("NAME", renderers.name, "Show keys, values, views, presets")->type_name("");

    auto& shaders = *app.add_subcommand("materials", "List built-in materials and their parameters");
    shaders.add_option("NAME", materials.name, "Show one alone")->type_name("");

    check_command(app, argc, argv);

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return PrintCommand{app.help()};
    } catch (const CLI::CallForVersion& version) {
        return PrintCommand{std::string(version.what()) + "\n"};
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (see prelight --help)");
    }

    if (app.got_subcommand("render")) {
        finish(render, render_text);
        return render;
    }
    if (app.got_subcommand("sequence")) {
        finish(sequence, sequence_picture, sequence_text);
        return sequence;
    }
    if (app.got_subcommand("view")) {
        finish(view, view_text);
        return view;
    }
    if (app.got_subcommand("compare")) {
        for (int i = 1; i < argc; ++i)
            compare.arguments += fmt::format("{}\n", argv[i]);
        finish(compare, compare_text);
        return compare;
    }
    if (app.got_subcommand("make")) {
        finish(make, make_text);
        return make;
    }
    if (app.got_subcommand("bench"))
        return bench.command();
    if (app.got_subcommand("renderers"))
        return renderers;
    if (app.got_subcommand("materials"))
        return materials;
    return DevicesCommand{};
}

} // namespace prelight::app
