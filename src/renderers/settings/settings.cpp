#include "settings.hpp"
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/views.hpp>
#include <setting_values/allows.hpp>
#include <setting_values/needs.hpp>

namespace prelight {

void Settings::set(const RendererInfo& info, const std::map<std::string, std::string>& settings) {
    for (const auto& [key, value] : settings) {
        const auto setting = std::find_if(info.settings.begin(), info.settings.end(),
                                          [&key = key](const SettingInfo& s) { return s.key == key; });
        if (setting == info.settings.end())
            throw UsageError(
                fmt::format("--set {}: {} has no such setting (prelight renderers {})", key, info.name, info.name));
        if (!allows(*setting, value))
            throw UsageError(fmt::format("--set {}={}: allowed is {}", key, value, fmt::join(setting->values, ", ")));
        values_[key] = value;
    }
}

Settings::Settings(const RendererInfo& info, const RenderOptions& options)
    : preset_(options.preset), views_(options.views), shading_(shading_in_force(info, options)), msaa_(options.msaa) {
    for (const SettingInfo& setting : info.settings)
        defaults_[setting.key] = setting.default_value;
    values_ = defaults_;
    const auto preset = info.preset_settings.find(options.preset);
    if (preset != info.preset_settings.end()) {
        set(info, preset->second);
        for (const auto& [key, value] : preset->second)
            of_preset_.insert(key);
    }
    set(info, options.settings);
    for (const auto& [key, value] : options.settings)
        given_.insert(key);
    for (const std::string& view : options.views)
        if (!has_view(info, view))
            throw UsageError(fmt::format("--view {}: {} has {}", view, info.name, names_of_views(info)));
    check_sample_views(options);
    if (!options.preset.empty() &&
        std::find(info.presets.begin(), info.presets.end(), options.preset) == info.presets.end())
        throw UsageError(fmt::format("--preset {}: {} has {}", options.preset, info.name,
                                     info.presets.empty() ? "none" : fmt::format("{}", fmt::join(info.presets, ", "))));
}

void Settings::refuse_without_effect() {
    for (const auto& [key, value] : values_) {
        if (value == defaults_.at(key))
            continue; // says nothing that would not be so anyway
        const std::optional<std::string> why = why_without_effect(key, values_, shading_, msaa_, views_);
        if (!why)
            continue;
        if (given(key))
            throw UsageError(fmt::format("--set {}={}: {}", key, value, *why));
        if (!of_preset_.contains(key))
            continue; // what another setting resolved it to
        // How shadows or samples are made, once somebody wants them.
        const std::string need = needs_of(key).front().key;
        const bool silent = need == "shadows" || need == "msaa";
        const std::string reason = fmt::format("{} (preset {})", *why, preset_);
        if (silent)
            resolve(key, defaults_.at(key), reason);
        else
            fall_back(key, defaults_.at(key), reason);
    }
}

Shading shading_in_force(const RendererInfo& info, const RenderOptions& options) {
    const auto preset = info.preset_shading.find(options.preset);
    return options.shading.value_or(preset == info.preset_shading.end() ? Shading::ggx : preset->second);
}

void Settings::resolve(const std::string& key, const std::string& value, const std::string& why) {
    const auto choice = choices_.try_emplace(key, SettingChoice{key, values_.at(key), {}, {}}).first;
    choice->second.taken = values_.at(key) = value;
    choice->second.why = why;
}

void Settings::fall_back(const std::string& key, const std::string& value, const std::string& why) {
    notes_.push_back(fmt::format("{}={}: {}, {} is taken", key, values_.at(key), why, value));
    resolve(key, value, why);
}

std::vector<SettingChoice> Settings::choices() const {
    std::vector<SettingChoice> all;
    for (const auto& [key, choice] : choices_)
        if (choice.taken != choice.asked)
            all.push_back(choice);
    return all;
}

double Settings::number(const std::string& key) const { return std::strtod(get(key).c_str(), nullptr); }

} // namespace prelight
