#include "commands.hpp"
#include "renderer_info.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/views.hpp>

namespace prelight::app {
namespace {

void print_one(const RendererInfo& info) {
    fmt::print("{}: {}\n", info.name, info.description);
    if (!info.settings.empty())
        fmt::print("\nsettings (--set KEY=VALUE):\n");
    for (const SettingInfo& setting : info.settings) {
        fmt::print("  {} = {}   (default {})\n      {}\n", setting.key, fmt::join(setting.values, " | "),
                   setting.default_value, setting.description);
        for (const SettingNeed& need : setting.needs)
            fmt::print("      needs {}{}{}\n", need.of_options() ? "--" + need.key + " " : need.key + "=",
                       fmt::join(need.values, " or "), need.or_view.empty() ? "" : " or --view " + need.or_view);
    }
    if (!info.views.empty())
        fmt::print("\nviews (--view): {}\n", names_of_views(info));
    if (!info.presets.empty())
        fmt::print("\npresets (--preset): {}\n", fmt::join(info.presets, ", "));
    for (const auto& [preset, settings] : info.preset_settings) {
        const auto shading = info.preset_shading.find(preset);
        fmt::print("  {}:{}", preset,
                   shading == info.preset_shading.end() ? ""
                   : shading->second == Shading::phong  ? " --shading phong"
                                                        : " --shading ggx");
        for (const auto& [key, value] : settings)
            fmt::print(" {}={}", key, value);
        fmt::print("\n");
    }
}

} // namespace

RendererInfo find_renderer(const std::string& name) {
    const std::vector<RendererInfo> infos = renderer_infos();
    const auto found = std::ranges::find(infos, name, &RendererInfo::name);
    if (found != infos.end())
        return *found;
    std::vector<std::string> names;
    for (const RendererInfo& info : infos)
        names.push_back(info.name);
    throw UsageError(fmt::format("{}: not a renderer ({})", name, fmt::join(names, ", ")));
}

void run(const RenderersCommand& command) {
    if (!command.name.empty())
        return print_one(find_renderer(command.name));
    for (const RendererInfo& info : renderer_infos())
        fmt::print("{:<14} {}\n", info.name, info.description);
}

void run(const PrintCommand& command) { fmt::print("{}", command.text); }

} // namespace prelight::app
