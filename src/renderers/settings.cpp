#include "settings.hpp"
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>

namespace prelight {
namespace {

/// A range "LOW … HIGH" stands for any number in it.
bool parse_range(const std::string& text, double& low, double& high) {
    const size_t dots = text.find(" … ");
    if (dots == std::string::npos)
        return false;
    low = std::strtod(text.c_str(), nullptr);
    high = std::strtod(text.c_str() + dots + std::string(" … ").size(), nullptr);
    return true;
}

bool allowed(const SettingInfo& info, const std::string& value) {
    double low = 0, high = 0;
    if (info.values.size() == 1 && parse_range(info.values[0], low, high)) {
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        return !value.empty() && *end == 0 && number >= low && number <= high;
    }
    return std::find(info.values.begin(), info.values.end(), value) != info.values.end();
}

} // namespace

void Settings::set(const RendererInfo& info, const std::map<std::string, std::string>& settings) {
    for (const auto& [key, value] : settings) {
        const auto setting = std::find_if(info.settings.begin(), info.settings.end(),
                                          [&key = key](const SettingInfo& s) { return s.key == key; });
        if (setting == info.settings.end())
            throw UsageError(fmt::format("--set {}: {} has no such setting (prelight renderers {})", key,
                                         info.name, info.name));
        if (!allowed(*setting, value))
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
