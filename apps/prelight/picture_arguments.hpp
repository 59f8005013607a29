#pragma once
#include "argument.hpp"
#include "command_line.hpp"

#include <CLI/CLI.hpp>

namespace prelight::app {

/// Everything `render` is given as text, before it is checked.
struct RenderText {
    std::string size = "1280x720", shading, tonemap = "pbr-neutral", output, stats;
    std::string lights, seed = "1", frames = "1", msaa, exposure = "0", time;
    std::vector<std::string> settings, views, materials;
    EnvironmentText environment;
    SceneReadingText reading;
    ViewText view;
};

/// How options are added: names, target, what stands for a value, help.
inline auto options_of(CLI::App& sub) {
    return [&sub](const char* names, auto& target, const char* word, const char* help) {
        return sub.add_option(names, target, help)->type_name(word)->allow_extra_args(false);
    };
}

template <class AnyCommand>
void take_exposure(AnyCommand& command, const std::string& text) {
    command.auto_exposure = text == "auto";
    if (!command.auto_exposure)
        command.options.exposure = parse_number("--exposure", text, -64, 64);
}

/// What says how one picture looks.
void add_picture_options(CLI::App& sub, RenderCommand& command, RenderText& text);
/// What of a picture, and of what it took, is written, for `render` and `sequence`.
void add_file_options(CLI::App& sub, RenderCommand& command, RenderText& text);
/// What of a scene's animations is shown, for `render` and `view`.
void add_moment_options(CLI::App& sub, RenderCommand& command, RenderText& text);
/// All but `--time` and what belongs to it, and the check of the outputs. Throws UsageError.
void finish_picture(RenderCommand& command, const RenderText& text);

} // namespace prelight::app
