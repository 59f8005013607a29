// Every option of the program, once. Two rows of a name stand for commands to which it means different things.
#include "option_table.hpp"

#include <algorithm>
#include <array>

namespace prelight::app {
namespace {

using namespace command_bit;
using enum OptionGroup;

constexpr uint32_t pictures = render | sequence | command_bit::view; ///< those that draw with one renderer
constexpr uint32_t shows = pictures | compare | bench_scene;         ///< those that show a scene
constexpr uint32_t reads = shows | info;

constexpr std::array table{
    // Which scene, and what is done to it.
    OptionRow{"--scene", "NAME|INDEX", scene, pictures | compare | info,
              "Which of the file's scenes (default the file's own default)"},
    OptionRow{"--scene", "SCENE", scene, figures,
              "Tables: file or built-in scene (default spheres). Scene: which of the file's scenes, NAME|INDEX",
              Takes::scene},
    OptionRow{"--lights", "N", scene, shows | bench_table,
              "Light count of a built-in scene; adds N random point lights to any other"},
    OptionRow{"--lights", "N", scene, make | info, "Light count of a built-in scene, 1 to 65536"},
    OptionRow{"--seed", "S", scene, shows | bench | make | info, "Seed of what is random (default 1)"},
    OptionRow{"--time", "SECONDS", scene, render | command_bit::view | compare | bench_scene,
              "Moment of the scene's animations (default: at rest)"},
    OptionRow{"--animation", "NAME|INDEX", scene, render | command_bit::view | compare | bench_scene,
              "Only this animation of the scene (default all), at --time or else at 0 s"},
    OptionRow{"--animation", "NAME|INDEX", scene, sequence, "Only this animation of the scene (default all)"},
    OptionRow{"--material", "NAME=FILE", scene, pictures,
              "Shade the glTF material NAME with a GLSL file of your own; repeatable (docs/materials.md)", Takes::file,
              "", true},
    OptionRow{"--environment", "NAME|FILE", scene, shows,
              "Light from all around: studio, none, or a picture twice as wide as high, .hdr, .exr or .png",
              Takes::environment},
    OptionRow{"--environment-intensity", "X", scene, shows, "Factor on the environment's light (default 1)"},
    OptionRow{"--environment-rotation", "DEGREES", scene, shows,
              "Turns it, counter-clockwise seen from above (default 0)"},
    OptionRow{"--strict", "", scene, reads, "What would be a warning about the file is an error"},
    OptionRow{"--memory-limit", "SIZE", scene, reads,
              "Memory to plan with when a file is read, as in 512M or 4G (default: what is free)"},

    // How one picture looks.
    OptionRow{"--size", "WxH", picture, pictures, "Picture size in pixels (default 1280x720)"},
    OptionRow{"--size", "WxH", picture, compare, "Picture size in pixels (default 960x540)"},
    OptionRow{"--size", "WxH", picture, figures, "Picture size in pixels (default 1280x720; a table has its own)"},
    OptionRow{"--camera", "NAME|INDEX", picture, shows | bench_table, "Camera of the scene (default the first)"},
    OptionRow{"--view-from", "AZIMUTH,ELEVATION", picture, shows,
              "Frame the scene from there, in degrees: 0,0 is the front (+Z), 90,0 the right (+X), 0,90 above (default "
              "20,15, where there is no camera)"},
    OptionRow{"--fit", "FACTOR", picture, shows,
              "Share of the picture that it fills in the tighter direction (default 0.8)"},
    OptionRow{"--background", "WHAT|COLOUR", picture, render,
              "What is seen behind the scene: environment, a soft backdrop, black, a colour as in #ff8800 or white, or "
              "transparent, for a PNG with alpha (docs/environment.md)",
              Takes::words, "environment backdrop black transparent white"},
    OptionRow{"--background", "WHAT", picture, sequence | command_bit::view | compare | bench_scene,
              "What is seen behind the scene: environment, a soft backdrop, or black (docs/environment.md)",
              Takes::words, "environment backdrop black"},
    OptionRow{"--msaa", "N", picture, pictures,
              "Samples per pixel (default 1; render, sequence: what makes edges smooth)", Takes::samples},
    OptionRow{"--msaa", "N", picture, compare | bench_scene, "Samples per pixel (default 1)", Takes::samples},
    OptionRow{"--shading", "MODEL", picture, shows, "ggx or phong (default: the preset's, else ggx)", Takes::words,
              "ggx phong"},
    OptionRow{"--tonemap", "CURVE", picture, pictures, "pbr-neutral (default), aces or none", Takes::words,
              "pbr-neutral aces none"},
    OptionRow{"--exposure", "EV|auto", picture, pictures | compare,
              "Multiplies light by 2^EV; auto: what suits the picture (default 0; auto for a file with far too bright "
              "lights)"},

    // Who draws it.
    OptionRow{"--renderer", "NAME", OptionGroup::renderer, pictures, "Architecture (default light-prepass)",
              Takes::renderer},
    OptionRow{"--preset", "NAME", OptionGroup::renderer, pictures, "A source text's own configuration", Takes::preset},
    OptionRow{"--set", "KEY=VALUE", OptionGroup::renderer, pictures, "One setting of the renderer; repeatable",
              Takes::setting, "", true},
    OptionRow{"--set", "KEY=VALUE", OptionGroup::renderer, bench_scene,
              "A setting of every renderer that has it; repeatable", Takes::setting, "", true},
    OptionRow{"--renderers", "LIST", OptionGroup::renderer, compare,
              "Architectures with settings, as in a,b@KEY=VALUE,c@preset=NAME (default all)", Takes::renderer},
    OptionRow{"--renderers", "LIST", OptionGroup::renderer, bench_scene,
              "What to time, as in a,b@KEY=VALUE,c@preset=NAME (default light-prepass,deferred)", Takes::renderer},

    // How many frames, and which.
    OptionRow{"--frames", "N", frames, render, "Frames to render and time (default 1)"},
    OptionRow{"--frames", "N", frames, command_bit::view,
              "How many steps of 1/60 s to play (default: up to the last event)"},
    OptionRow{"--frames", "N", frames, compare, "Frames of each variant to time, interleaved (default 5)"},
    OptionRow{"--frames", "N", frames, figures, "Frames of each way to time, interleaved (default 9; claims 5)"},
    OptionRow{"--light-counts", "LIST", frames, compare,
              "Numbers of lights of the chart (default 1,4,16,64,256,1024,4096), or none"},
    OptionRow{"--light-counts", "LIST", frames, bench_scene,
              "Numbers of lights, as in 16,256,4096 (default its own; a file without lights gets 256)"},
    OptionRow{"--frame-limit", "SECONDS", frames, compare,
              "A slower frame ends a variant's line in the chart (default 1)"},
    OptionRow{"--budget", "SECONDS", frames, bench_scene | compare,
              "End in that time: fewer frames, and the last numbers of lights left out (default: all of them)"},
    OptionRow{"--limit", "", frames, bench_scene, "Measure what the device could do, and give frames in units of F"},
    OptionRow{"--count-pairs", "", frames, bench_scene,
              "Light x pixel pairs are always counted, in a frame that is not timed"},
    OptionRow{"--frames-at", "LIST", frames, sequence, "Frames to draw: all (default), 47, 0-29, 3,5-10, 0-99x3, ..."},
    OptionRow{"--fps", "F", frames, sequence, "Frames a second: frame f shows the time f/F (default 30)"},
    OptionRow{"--turntable", "SECONDS", frames, sequence, "The camera goes round the scene, once in so many seconds"},
    OptionRow{"--loop", "SECONDS", frames, sequence,
              "The animations begin again whenever they end, for so many seconds"},
    OptionRow{"--skip-existing", "", frames, sequence, "Leave out frames whose files are there and whole"},
    OptionRow{"--shard", "I/N", frames, sequence, "Draw every N-th frame of the list, from the I-th on (I from 1)"},
    OptionRow{"--watch", "", frames, render, "Render again whenever the scene or a material file changes"},
    OptionRow{"--watch", "", frames, command_bit::view, "What view does anyway: files that change are read again"},
    OptionRow{
        "--scale", "FACTOR|auto", frames, command_bit::view,
        "Pixels drawn for one of the window's, along each side, 0.1 to 1; auto: what keeps it fluent (default 1)"},
    OptionRow{"--play", "FILE", frames, command_bit::view, "Input from FILE; with -o without any window", Takes::file},

    // What is written.
    OptionRow{
        "-o,--output", "IMAGE", output, render,
        "The picture: PNG, or EXR when the name ends so; - is standard output; {name} stands for the scene's name",
        Takes::file, "", false, true},
    OptionRow{"-o,--output", "FILES", output, sequence,
              "Numbered pictures, as in out.####.png or out.####.exr; or a video: out.mp4, out.mkv", Takes::file, "",
              false, true},
    OptionRow{"-o,--output", "PICTURE", output, command_bit::view, "What is seen at the end of --play: PNG or EXR",
              Takes::file},
    OptionRow{"-o,--output", "FOLDER", output, compare, "Where the report goes", Takes::folder, "", false, true},
    OptionRow{"-o,--output", "PAGE", output, bench_report, "The page to write, .html", Takes::file},
    OptionRow{"-o,--output", "GLB", output, make, "The file to write", Takes::file, "", false, true},
    OptionRow{"--view", "BUFFER[=FILE]", output, render | sequence,
              "Write this buffer in place of the picture; with =FILE.png, beside it; repeatable", Takes::view, "",
              true},
    OptionRow{"--view", "BUFFER", output, command_bit::view, "Show this buffer in place of the picture", Takes::view,
              "", true},
    OptionRow{"--record", "FILE", output, command_bit::view, "Write all input to FILE", Takes::file},
    OptionRow{"--stats", "FILE", output, render | sequence, "Write the run's figures as JSON", Takes::file},
    OptionRow{"--count-pairs", "", output, render | sequence, "Count light x pixel pairs for --stats (not for timing)"},
    OptionRow{"--pass-cpu", "", output, render | sequence,
              "Each pass's CPU time for --stats: as many frames more, each pass submitted alone"},
    OptionRow{"--json", "FILE", output, figures, "Write the figures as JSON too", Takes::file},
    OptionRow{"--json", "", output, info, "Print everything as JSON"},
    OptionRow{"--baseline", "FILE", output, bench_scene, "Print the change since a file of --json", Takes::file},

    // Where it runs.
    OptionRow{"--device", "DEVICE", device, shows | bench, "auto (default), cpu, an index or a name", Takes::device},
    OptionRow{"--validate", "", diagnostics, shows | bench_table,
              "Run with Vulkan validation; any message is a failure"},
    OptionRow{"--log-level", "LEVEL", diagnostics, reads, "What stderr shows: error, warning or info (default)",
              Takes::words, "error warning info"},
    OptionRow{"--quiet", "", diagnostics, shows | bench | make,
              "Print only warnings, errors and what was asked for: no progress, no line for what was written"},
};

} // namespace

std::string_view group_title(OptionGroup group) {
    switch (group) {
    case scene: return "Scene";
    case picture: return "Picture";
    case OptionGroup::renderer: return "Renderer";
    case frames: return "Frames";
    case output: return "Output";
    case device: return "Device";
    default: return "Diagnostics";
    }
}

std::vector<std::string> split_words(std::string_view text, char separator) {
    std::vector<std::string> words;
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find(separator, at), text.size());
        if (end > at)
            words.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

std::string OptionRow::short_name() const { return split_words(names, ',').front(); }

std::string OptionRow::long_name() const { return split_words(names, ',').back(); }

std::string OptionRow::usage() const {
    std::string text = short_name();
    if (text != long_name())
        text += ", " + long_name();
    return word.empty() ? text : text + " " + std::string(word);
}

std::span<const OptionRow> option_table() { return table; }

std::vector<const OptionRow*> options_of(const CommandRow& command) {
    std::vector<const OptionRow*> rows;
    for (const OptionRow& row : table)
        if (row.commands & command.bits)
            rows.push_back(&row);
    return rows;
}

} // namespace prelight::app
