#pragma once
#include <algorithm>
#include <charconv>
#include <optional>
#include <prelight/renderer.hpp>
#include <string>
#include <string_view>

namespace prelight {

/// The largest number of a layer that is shown by itself.
inline constexpr uint32_t most_shown_layers = 256;

/// Of a buffer named "layer=N", N: 1 for the blended surface of each pixel that is nearest, 2 for the next one … 256.
/// The buffer shows it by its alpha over black, and black where a pixel has fewer. None for every other name.
inline std::optional<uint32_t> layer_of_view(std::string_view view) {
    constexpr std::string_view start = "layer=";
    if (!view.starts_with(start) || view.substr(start.size()).starts_with('0'))
        return {};
    uint32_t number = 0;
    const char* const end = view.data() + view.size();
    const auto [at, error] = std::from_chars(view.data() + start.size(), end, number);
    if (error != std::errc() || at != end || number > most_shown_layers)
        return {};
    return number;
}

/// Whether a renderer has the buffer: one of its `views`, or "layer=N" where "layers" is one of them.
inline bool has_view(const RendererInfo& info, std::string_view view) {
    const auto lists = [&](std::string_view name) {
        return std::find(info.views.begin(), info.views.end(), name) != info.views.end();
    };
    return lists(view) || (layer_of_view(view) && lists("layers"));
}

/// All that it has, for a line of text.
inline std::string names_of_views(const RendererInfo& info) {
    std::string names;
    for (const std::string& view : info.views)
        names += (names.empty() ? "" : ", ") + view;
    return has_view(info, "layer=1") ? names + ", layer=1 … layer=" + std::to_string(most_shown_layers) : names;
}

} // namespace prelight
