#include "axes.hpp"
#include <algorithm>
#include <stdexcept>
#include <utility>

namespace prelight {
namespace {

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(' ');
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(" \r") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    for (size_t end = 0; end != text.npos;) {
        end = text.find(at);
        parts.push_back(trimmed(text.substr(0, end)));
        if (end != text.npos)
            text.remove_prefix(end + 1);
    }
    std::erase(parts, "");
    return parts;
}

gpu::Variant variant(std::string_view macro) {
    const auto found = std::find(std::begin(gpu::variant_macros), std::end(gpu::variant_macros), macro);
    if (found == std::end(gpu::variant_macros))
        throw std::runtime_error("no variant " + std::string(macro) + " (src/gpu/shader_key.hpp has them all)");
    return static_cast<gpu::Variant>(found - std::begin(gpu::variant_macros));
}

gpu::Variants variants(std::string_view macros) {
    gpu::Variants out;
    for (const std::string_view one : split(macros, ' '))
        out |= variant(one);
    return out;
}

/// "WHAT with WITH"
std::pair<std::string_view, std::string_view> with(std::string_view text) {
    constexpr std::string_view word = " with ";
    const size_t at = text.find(word);
    if (at == text.npos)
        throw std::runtime_error("'" + std::string(text) + "': not 'WHAT with VARIANT'");
    return {trimmed(text.substr(0, at)), trimmed(text.substr(at + word.size()))};
}

bool allows(const ShaderAxes& axes, gpu::Variants set) {
    return std::none_of(axes.never.begin(), axes.never.end(), [&](gpu::Variants all) { return set.has_all(all); }) &&
           std::all_of(axes.only.begin(), axes.only.end(), [&](const auto& rule) {
               return !set.has_all(rule.first) || std::any_of(rule.second.begin(), rule.second.end(),
                                                              [&](gpu::Variants other) { return set.has_all(other); });
           });
}

} // namespace

ShaderAxes read_axes(std::string_view source) {
    ShaderAxes axes;
    for (const std::string_view line : split(source, '\n')) {
        if (line.starts_with("#version") || line.starts_with("#extension"))
            continue;
        if (!line.starts_with("//"))
            break; // axes stand at the top
        const std::string_view text = trimmed(line.substr(2));
        const size_t colon = text.find(':');
        if (colon == text.npos)
            continue;
        const std::string_view key = text.substr(0, colon);
        for (const std::string_view part : key == "variants" || key == "never" || key == "only" || key == "materials"
                                               ? split(text.substr(colon + 1), ',')
                                               : std::vector<std::string_view>()) {
            if (key == "variants") {
                std::vector<gpu::Variants> choices{{}};
                for (const std::string_view one : split(part, '|'))
                    choices.push_back(variant(one));
                axes.choices.push_back(std::move(choices));
            } else if (key == "never") {
                axes.never.push_back(variants(part));
            } else if (key == "only") {
                auto& [what, others] = axes.only.emplace_back();
                what = variants(with(part).first);
                for (const std::string_view other : split(with(part).second, '|'))
                    others.push_back(variants(other));
            } else {
                constexpr std::string_view only = "only ";
                std::string_view what = with(part).first;
                const bool alone = what.starts_with(only);
                if (alone)
                    what = trimmed(what.substr(only.size()));
                axes.materials.push_back({std::string(what), variants(with(part).second), alone});
            }
        }
    }
    return axes;
}

std::vector<gpu::ShaderKey> all_keys(const std::string& file, const ShaderAxes& axes,
                                     const std::vector<std::string>& materials) {
    std::vector<gpu::Variants> sets{{}};
    for (const std::vector<gpu::Variants>& choices : axes.choices) {
        const std::vector<gpu::Variants> before = std::exchange(sets, {});
        for (const gpu::Variants set : before)
            for (const gpu::Variants choice : choices)
                sets.push_back(set | choice);
    }
    std::vector<gpu::ShaderKey> keys;
    for (const gpu::Variants set : sets) {
        if (!allows(axes, set))
            continue;
        const auto alone = std::find_if(axes.materials.begin(), axes.materials.end(), [&](const ShaderAxes::Pair& one) {
            return one.alone && set.has_all(one.with);
        });
        if (alone != axes.materials.end()) {
            keys.emplace_back(file, set, alone->what);
            continue;
        }
        bool all = false;
        for (const ShaderAxes::Pair& material : axes.materials) {
            if (!set.has_all(material.with) || material.alone)
                continue;
            all = all || material.what == "all";
            for (const std::string& name : material.what == "all" ? materials : std::vector{material.what})
                keys.emplace_back(file, set, name);
        }
        if (!all)
            keys.emplace_back(file, set);
    }
    return keys;
}

} // namespace prelight
