#include "settings.hpp"
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <setting_values/allows.hpp>

namespace prelight {

void Settings::set(const RendererInfo& info, const std::map<std::string, std::string>& settings) {
    for (const auto& [key, value] : settings) {
        const auto setting = std::find_if(info.settings.begin(), info.settings.end(),
                                          [&key = key](const SettingInfo& s) { return s.key == key; });
        if (setting == info.settings.end())
            throw UsageError(fmt::format("--set {}: {} has no such setting (prelight renderers {})", key,
                                         info.name, info.name));
        if (!allows(*setting, value))
            throw UsageError(fmt::format("--set {}={}: allowed is {}", key, value,
                                         fmt::join(setting->values, ", ")));
        values_[key] = value;
    }
}

Settings::Settings(const RendererInfo& info, const RenderOptions& options) {
    for (const SettingInfo& setting : info.settings)
        values_[setting.key] = setting.default_value;
    const auto preset = info.preset_settings.find(options.preset);
    if (preset != info.preset_settings.end())
        set(info, preset->second);
    set(info, options.settings);
    for (const auto& [key, value] : options.settings)
        given_.insert(key);
    for (const std::string& view : options.views)
        if (std::find(info.views.begin(), info.views.end(), view) == info.views.end())
            throw UsageError(fmt::format("--view {}: {} has {}", view, info.name, fmt::join(info.views, ", ")));
    if (!options.preset.empty() &&
        std::find(info.presets.begin(), info.presets.end(), options.preset) == info.presets.end())
        throw UsageError(fmt::format("--preset {}: {} has {}", options.preset, info.name,
                                     info.presets.empty() ? "none" : fmt::format("{}", fmt::join(info.presets, ", "))));
}

double Settings::number(const std::string& key) const { return std::strtod(get(key).c_str(), nullptr); }

} // namespace prelight
