#include "../commands.hpp"
#include "../options/suggestion.hpp"
#include "../output.hpp"
#include "../renderer_info.hpp"
#include "../scene_source.hpp"
#include "../session.hpp"
#include "player.hpp"
#include "window_run.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <prelight/views.hpp>

namespace prelight::app {
namespace {

/// Outputs can be written, and none of them is what is read.
void check_files(const ViewCommand& command) {
    std::vector<std::filesystem::path> outputs;
    for (const auto& output : {command.render.output, command.record})
        if (!output.empty())
            outputs.push_back(output);
    std::vector<std::filesystem::path> inputs = inputs_of(command.render);
    inputs.push_back(command.play);
    check_distinct(outputs, inputs);
    for (const auto& output : outputs)
        check_writable(output);
}

} // namespace

void run(const ViewCommand& command) {
    const RendererInfo info = find_renderer(command.render.renderer);
    const std::string& view = command.render.view;
    if (view != "final" && (view == "linear" || !has_view(info, view)))
        throw UsageError(fmt::format("--view {}: {} has {}{}", view, info.name, names_of_views(info),
                                     did_you_mean(view, info.views)));
    check_scene_name(command.render.scene);
    check_files(command);
    if (command.play.empty() || command.render.output.empty())
        viewer::run_window(command);
    else
        viewer::play(command);
}

} // namespace prelight::app
