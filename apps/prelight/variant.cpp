#include "variant.hpp"

#include "argument.hpp"
#include "renderer_info.hpp"

#include <algorithm>
#include <fmt/ranges.h>

namespace prelight::app {
namespace {

/// Settings worth a place beside an architecture's own default. Where a renderer lacks the key or the
/// value, the row means nothing. Not here: light-culling=fullscreen, which with a thousand lights takes
/// longer than everything else together.
struct Worth {
    std::string_view renderer, key;
    std::vector<std::string_view> values;
};

std::vector<Worth> worth_showing() {
    return {
        {"light-prepass", "light-culling", {"volumes", "rectangles", "stencil", "clusters"}},
        {"light-prepass", "light-buffer", {"packed-rgba16f"}},
        {"deferred", "light-culling", {"volumes", "clusters"}},
        {"z-prepass", "lights", {"per-draw", "grid"}},
        {"multipass", "lights-per-pass", {"8"}},
    };
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

Variant parse_variant(std::string_view option, const std::string& text) {
    const std::vector<std::string> parts = split(text, '@');
    Variant variant{.renderer = parts[0]};
    if (variant.renderer.empty())
        throw UsageError(fmt::format("{}: not a list of NAME or NAME@KEY=VALUE, separated by commas", option));
    const RendererInfo info = find_renderer(variant.renderer);
    for (size_t i = 1; i < parts.size(); ++i) {
        const auto [key, value] = parse_pair(option, parts[i]);
        if (key != "preset") {
            check_setting(fmt::format("{} {}@{}={}", option, info.name, key, value), info, key, value);
            variant.settings[key] = value;
        } else {
            check_preset(fmt::format("{} {}", option, text), info, value);
            variant.preset = value;
        }
    }
    return variant;
}

} // namespace

std::string Variant::name() const {
    std::string text = renderer;
    if (!preset.empty())
        text += "@preset=" + preset;
    for (const auto& [key, value] : settings)
        text += "@" + key + "=" + value;
    return text;
}

std::vector<Variant> parse_variants(std::string_view option, const std::string& text) {
    std::vector<Variant> variants;
    for (const std::string& part : split(text, ',')) {
        Variant variant = parse_variant(option, part);
        if (std::ranges::find(variants, variant) != variants.end())
            throw UsageError(fmt::format("{} {}: named twice", option, variant.name()));
        variants.push_back(std::move(variant));
    }
    return variants;
}

std::vector<Variant> standard_variants(const std::vector<RendererInfo>& infos) {
    std::vector<Variant> variants;
    for (const RendererInfo& info : infos) {
        if (info.name == "reference")
            continue;
        variants.push_back({.renderer = info.name});
        for (const std::string& preset : info.presets)
            variants.push_back({.renderer = info.name, .preset = preset});
        for (const auto& [renderer, key, wanted] : worth_showing()) {
            const auto setting = std::ranges::find(info.settings, key, &SettingInfo::key);
            if (renderer != info.name || setting == info.settings.end())
                continue;
            for (const std::string& value : setting->values)
                if (value != setting->default_value && std::ranges::find(wanted, value) != wanted.end())
                    variants.push_back({.renderer = info.name, .settings = {{setting->key, value}}});
        }
    }
    return variants;
}

} // namespace prelight::app
