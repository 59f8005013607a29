#include "commands.hpp"
#include "options/suggestion.hpp"
#include "renderer_info.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/views.hpp>
#include <setting_values/allows.hpp>
#include <setting_values/needs.hpp>

namespace prelight::app {

std::string renderer_text(const RendererInfo& info) {
    std::string text = fmt::format("{}: {}\n", info.name, info.description);
    if (!info.settings.empty())
        text += fmt::format("\nsettings (--set KEY=VALUE):\n");
    for (const SettingInfo& setting : info.settings) {
        text += fmt::format("  {} = {}   (default {})\n      {}\n", setting.key, fmt::join(setting.values, " | "),
                            setting.default_value, setting.description);
        for (const SettingNeed& need : setting.needs)
            text += fmt::format("      needs {}\n", need_text(need));
    }
    if (!info.views.empty())
        text += fmt::format("\nviews (--view): {}\n", names_of_views(info));
    if (!info.presets.empty())
        text += fmt::format("\npresets (--preset): {}\n", fmt::join(info.presets, ", "));
    for (const auto& [preset, settings] : info.preset_settings) {
        const auto shading = info.preset_shading.find(preset);
        text += fmt::format("  {}:{}", preset,
                            shading == info.preset_shading.end() ? ""
                            : shading->second == Shading::phong  ? " --shading phong"
                                                                 : " --shading ggx");
        for (const auto& [key, value] : settings)
            text += fmt::format(" {}={}", key, value);
        text += "\n";
    }
    return text;
}

std::vector<std::string> keys_of(const RendererInfo& info) {
    std::vector<std::string> keys;
    for (const SettingInfo& setting : info.settings)
        keys.push_back(setting.key);
    return keys;
}

std::vector<std::string> renderer_names() {
    std::vector<std::string> names;
    for (const RendererInfo& info : renderer_infos())
        names.push_back(info.name);
    return names;
}

RendererInfo find_renderer(const std::string& name) {
    const std::vector<RendererInfo> infos = renderer_infos();
    const auto found = std::ranges::find(infos, name, &RendererInfo::name);
    if (found != infos.end())
        return *found;
    const std::vector<std::string> names = renderer_names();
    throw UsageError(fmt::format("{}: not a renderer ({}){}", name, fmt::join(names, ", "), did_you_mean(name, names)));
}

void check_setting(std::string_view as_typed, const RendererInfo& info, const std::string& key,
                   const std::string& value) {
    const auto setting = std::ranges::find(info.settings, key, &SettingInfo::key);
    if (setting == info.settings.end())
        throw UsageError(fmt::format("{}: {} has no setting {} (prelight renderers {}){}", as_typed, info.name, key,
                                     info.name, did_you_mean(key, keys_of(info))));
    if (!allows(*setting, value))
        throw UsageError(fmt::format("{}: allowed is {}{}", as_typed, fmt::join(setting->values, ", "),
                                     did_you_mean(value, setting->values)));
}

void check_preset(std::string_view as_typed, const RendererInfo& info, const std::string& preset) {
    if (std::ranges::find(info.presets, preset) != info.presets.end())
        return;
    throw UsageError(
        fmt::format("{}: {} has no preset {} ({}){}", as_typed, info.name, preset,
                    info.presets.empty() ? "it has none" : fmt::format("{}", fmt::join(info.presets, ", ")),
                    did_you_mean(preset, info.presets)));
}

void run(const RenderersCommand& command) {
    if (!command.name.empty())
        return fmt::print("{}", renderer_text(find_renderer(command.name)));
    for (const RendererInfo& info : renderer_infos())
        fmt::print("{:<14} {}\n", info.name, info.description);
}

void run(const PrintCommand& command) { fmt::print("{}", command.text); }

} // namespace prelight::app
