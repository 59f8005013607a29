#pragma once
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <prelight/views.hpp>
#include <setting_values/sample_counts.hpp>
#include <string>
#include <vector>

namespace prelight {

/// What has to be in force for a setting to make any difference, whichever renderer has it.
inline std::vector<SettingNeed> needs_of(const std::string& key) {
    static const SettingNeed several_samples{"msaa", sample_counts_above(1)};
    static const std::multimap<std::string, SettingNeed> needs{
        {"model", {"shading", {"ggx"}}},
        {"specular", {"shading", {"phong"}}},
        {"specular-gate", {"shading", {"phong"}}},
        {"specular-vector", {"shading", {"phong"}}},
        {"specular-light", {"shading", {"phong"}}},
        {"specular-light", {"specular", {"stored"}}},
        {"roughness", {"specular", {"stored"}}},
        {"light-scale", {"light-buffer", {"rgb10a2", "rgba8", "packed-rgba8"}}},
        {"light-scale", {"accumulation", {"rgba8"}}},
        {"few-lights", {"light-buffer", {"rgba16f"}}},
        {"few-lights", {"ambient", {"material"}}},
        {"tile-size", {"light-culling", {"tiles", "clusters"}}},
        {"list-shading", {"light-culling", {"tiles"}}},
        {"light-lists", {"light-culling", {"tiles"}}},
        {"spot-volume", {"light-culling", {"volumes", "stencil"}}},
        {"volume-depth-test", {"light-culling", {"volumes"}}},
        {"depth-bounds", {"light-culling", {"rectangles"}}},
        {"transparent-shadows", {"shadows", {"on"}}},
        {"transparent-shadows",
         {"transparency", {"layers", "lists", "sorted", "peeled", "k-buffer", "weighted", "half-samples"}}},
        {"shadow-filter", {"shadows", {"on"}}},
        {"shadow-budget", {"shadows", {"on"}}},
        {"shadow-detail", {"shadows", {"on"}}},
        {"shadow-cache", {"shadows", {"on"}}},
        {"shadow-updates", {"shadows", {"on"}}},
        {"shadow-updates", {"shadow-memory", {"atlas"}}},
        {"shadow-memory", {"shadows", {"on"}}},
        {"ssao-radius", {"ssao", {"half", "full"}, "ambient-occlusion"}},
        {"ambient-occlusion-radius", {"ambient-occlusion", {"on"}, "ambient-occlusion"}},
        {"blended-lights", {"transparency", {"sorted"}}},
        {"peeled-layers", {"transparency", {"peeled"}}},
        {"k-buffer-layers", {"transparency", {"k-buffer"}}},
        {"layer-light", {"transparency", {"peeled", "k-buffer"}}},
        {"antialiasing", {"msaa", {"1"}}},
        {"inferred-scale", {"msaa", {"1"}}},
        {"msaa-light", several_samples},
        {"msaa-material", several_samples},
        {"msaa-geometry", several_samples},
        {"msaa-shadows", several_samples},
        {"msaa-shadows", {"shadows", {"on"}}},
        {"msaa-shadows", {"msaa-light", {"edges", "samples"}}},
        {"msaa-layers", several_samples},
        {"msaa-layers", {"transparency", {"layers"}}}};
    std::vector<SettingNeed> found;
    for (auto [it, end] = needs.equal_range(key); it != end; ++it)
        found.push_back(it->second);
    return found;
}

/// Of them, what concerns a renderer with these settings, with the values that it knows.
inline std::vector<SettingNeed> needs_of(const std::string& key, const std::vector<SettingInfo>& settings) {
    std::vector<SettingNeed> found;
    for (SettingNeed need : needs_of(key)) {
        const auto of =
            std::find_if(settings.begin(), settings.end(), [&](const SettingInfo& one) { return one.key == need.key; });
        if (of != settings.end()) {
            std::erase_if(need.values, [&](const std::string& value) {
                return std::find(of->values.begin(), of->values.end(), value) == of->values.end();
            });
            if (need.values.size() == of->values.size())
                continue; // whatever it is
        } else if (!need.of_options()) {
            continue;
        }
        found.push_back(std::move(need));
    }
    return found;
}

/// Of transparency=half-samples. Throws UsageError for another number of samples a pixel than it needs, and for views
/// of single layers or samples.
inline void check_half_samples(const RenderOptions& options) {
    if (options.msaa != 4)
        throw UsageError(fmt::format("--set transparency=half-samples: needs --msaa 4, and it is {}", options.msaa));
    for (const std::string& view : options.views) {
        if (layer_of_view(view))
            throw UsageError(fmt::format("--view {}: transparency=half-samples draws one layer, as if it were opaque "
                                         "(with any other value all are shown)",
                                         view));
        if (const auto one = sample_of_view(view); one && one->buffer == "final")
            throw UsageError(fmt::format("--view {}: with transparency=half-samples no sample is a picture by itself "
                                         "(with any other value each is)",
                                         view));
    }
}

/// Throws UsageError for views of samples that a pixel does not have, or of its only one.
inline void check_sample_views(const RenderOptions& options) {
    for (const std::string& view : options.views)
        if (const auto one = sample_of_view(view); one && (options.msaa == 1 || one->sample >= options.msaa))
            throw UsageError(fmt::format("--view {}: needs --msaa {}, and it is {}", view,
                                         fmt::join(sample_counts_above(std::max(one->sample, 1u)), " or "),
                                         options.msaa));
}

inline const char* shading_name(Shading shading) { return shading == Shading::ggx ? "ggx" : "phong"; }

/// A need as a user is told of it: "--msaa 2 or 4", "shadows=on or --view ambient-occlusion".
inline std::string need_text(const SettingNeed& need) {
    return fmt::format("{}{}{}", need.of_options() ? "--" + need.key + " " : need.key + "=",
                       fmt::join(need.values, " or "), need.or_view.empty() ? "" : " or --view " + need.or_view);
}

/// Why a setting makes no difference with the values in force: what it needs; empty where it does make one. `msaa`:
/// samples a pixel.
inline std::optional<std::string> why_without_effect(const std::string& key,
                                                     const std::map<std::string, std::string>& in_force,
                                                     Shading shading, uint32_t msaa,
                                                     const std::vector<std::string>& views) {
    for (const SettingNeed& need : needs_of(key)) {
        if (!need.of_options() && !in_force.contains(need.key))
            continue;
        const std::string value = need.key == "shading" ? shading_name(shading)
                                  : need.key == "msaa"  ? std::to_string(msaa)
                                                        : in_force.at(need.key);
        const auto has = [](const std::vector<std::string>& all, const std::string& one) {
            return std::find(all.begin(), all.end(), one) != all.end();
        };
        if (has(need.values, value) || (!need.or_view.empty() && has(views, need.or_view)))
            continue;
        if (need.values.size() > 4)
            return fmt::format("needs another value than {}={}", need.key, value);
        return fmt::format("needs {}, and it is {}", need_text(need), value);
    }
    return {};
}

} // namespace prelight
