// Every command of the program, once.
#include "option_table.hpp"

#include <algorithm>

namespace prelight::app {

const std::vector<CommandRow>& command_table() {
    constexpr std::string_view a_scene = "A .gltf or .glb file, or a built-in scene (prelight help scenes)";
    constexpr std::string_view a_scene_or_input =
        "A .gltf or .glb file, - for a .glb from standard input, or a built-in scene (prelight help scenes). Several "
        "need {name} in the outputs' names";
    static const std::vector<CommandRow> commands{
        {"render",
         command_bit::render,
         "Render a scene into a picture",
         {{"SCENE", a_scene_or_input, Takes::scene, true, true}},
         "A name ending in .exr receives exposed scene-linear values, without tone mapping.\n"
         "`prelight renderers NAME` lists what --set, --view and --preset accept.",
         R"(prelight render city --lights 4096 --seed 7 -o city.png --stats city.json
prelight render helmet.glb --set normals=oct32 --shading phong -o helmet.png
prelight render city -o city.png --view normal=normal.png --view depth=depth.png
prelight render fox.glb --animation Run --time 0.4 -o fox.png
prelight render city --view diffuse-light -o light.png
prelight render helmet.glb --environment sky.hdr --environment-rotation 90 -o helmet.png
prelight render helmet.glb --view-from 0,90 --fit 0.95 --exposure auto -o above.png
prelight render helmet.glb --material Visor=toon.glsl -o helmet.png --watch
prelight render city --renderer reference --size 320x180 -o truth.exr
prelight render helmet.glb --background transparent -o helmet.png
prelight render helmet.glb fox.glb -o '{name}.png')"},
        {"sequence",
         command_bit::sequence,
         "Render many moments: numbered pictures, or a video",
         {{"SCENE", a_scene, Takes::scene}},
         "Frame f shows the time f/F seconds, whatever was drawn before it. Without --frames-at: the animations up to "
         "their last keyframe, or one round of the turntable. docs/sequences.md has more.",
         R"(prelight sequence fox.glb --animation Run -o run.####.png
prelight sequence helmet.glb --turntable 10 -o helmet.mp4
prelight sequence city --turntable 4 --fps 24 --frames-at 0-95x8 --size 640x360 -o city.####.png
prelight sequence fox.glb --shard 2/6 --skip-existing -o run.####.png)"},
        {"view",
         command_bit::view,
         "Show a scene in a window",
         {{"SCENE", a_scene, Takes::scene}},
         "Keys: ? lists them. docs/view.md has the rest.",
         R"(prelight view city --lights 4096
prelight view helmet.glb --environment sky.hdr --scale auto
prelight view motion --record session.txt
prelight view motion --play session.txt -o picture.png)"},
        {"compare",
         command_bit::compare,
         "Show every architecture side by side as a web page",
         {{"SCENE", a_scene, Takes::scene}},
         "Writes FOLDER/index.html, which opens from disk, FOLDER/report.json and FOLDER/pictures. An earlier report "
         "in FOLDER is replaced; a folder with other files is refused.",
         R"(prelight compare city -o report
prelight compare scene.glb --lights 500 --size 640x360 -o report
prelight compare city --renderers light-prepass,multipass@lights-per-pass=8 -o report
prelight compare city --light-counts 16,256 --frames 3 -o report)"},
        {"bench",
         command_bit::bench,
         "Measure, and print a table",
         {{"WHAT", "A .gltf or .glb file or built-in scene to time, a table below, or report", Takes::scene},
          {"FILE", "report: files of --json, side by side", Takes::file, false, true}},
         "Tables of their own: encodings, light-buffers, claims.",
         R"(prelight bench lights --light-counts 16,256,4096 --limit --json lights.json
prelight bench city --renderers light-prepass,deferred@light-culling=tiles --frames 5
prelight bench lights --light-counts 16,256,4096 --limit --baseline lights.json
prelight bench report lights.json -o lights.html
prelight bench encodings --json encodings.json)"},
        {"make",
         command_bit::make,
         "Write a built-in scene as glTF",
         {{"NAME", "A built-in scene (prelight help scenes)", Takes::scene}},
         "",
         "prelight make city --lights 256 --seed 3 -o city.glb"},
        {"info",
         command_bit::info,
         "Tell what is in a scene",
         {{"SCENE", a_scene, Takes::scene}},
         "Meshes, materials, pictures, lights with their units, cameras, animations, the extensions that the file uses "
         "and how far each is honoured, memory. docs/gltf.md describes the JSON.",
         R"(prelight info helmet.glb
prelight info city --lights 64 --json)"},
        {"devices", command_bit::devices, "Show the Vulkan devices and which would be taken"},
        {"renderers",
         command_bit::renderers,
         "List renderers, or what one of them can do",
         {{"NAME", "Show keys, values, views, presets", Takes::renderer, false}},
         "",
         "prelight renderers light-prepass"},
        {"materials",
         command_bit::materials,
         "List built-in materials and their parameters",
         {{"NAME", "Show one alone", Takes::text, false}}},
        {"help",
         command_bit::help,
         "Explain a command, an option, a setting or another topic",
         {{"TOPIC", "What to explain; none: lists the topics", Takes::text, false, true}},
         "",
         R"(prelight help render
prelight help settings
prelight help light-culling
prelight help exit status)"},
        {.name = "completions",
         .bits = command_bit::completions,
         .summary = "Print a completion script",
         .positionals = {{"SHELL", "bash, zsh or fish"}},
         .hidden = true},
        {.name = "man",
         .bits = command_bit::man,
         .summary = "Print a manual page",
         .positionals = {{"COMMAND", "Whose; none: the program's", Takes::text, false}},
         .hidden = true},
    };
    return commands;
}

const CommandRow* find_command(std::string_view name) {
    const auto found = std::ranges::find(command_table(), name, &CommandRow::name);
    return found == command_table().end() ? nullptr : &*found;
}

std::vector<std::string> command_names() {
    std::vector<std::string> names;
    for (const CommandRow& command : command_table())
        if (!command.hidden)
            names.emplace_back(command.name);
    return names;
}

} // namespace prelight::app
