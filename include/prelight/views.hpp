#pragma once
#include <algorithm>
#include <charconv>
#include <optional>
#include <prelight/renderer.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace prelight {

/// The largest number of a layer that is shown by itself.
inline constexpr uint32_t most_shown_layers = 256;

/// How the names of views of single layers begin; a number follows.
inline constexpr std::string_view layer_view_start = "layer=";
/// How those of single samples begin, each with the buffer that it is of.
inline constexpr std::pair<std::string_view, std::string_view> sample_view_starts[] = {
    {"sample=", "final"}, {"depth-sample=", "depth"}, {"normal-sample=", "normal"}};

/// Of a buffer named "layer=N", N: 1 for the blended surface of each pixel that is nearest, 2 for the next one … 256.
/// The buffer shows it by its alpha over black, and black where a pixel has fewer. None for every other name.
inline std::optional<uint32_t> layer_of_view(std::string_view view) {
    constexpr std::string_view start = layer_view_start;
    if (!view.starts_with(start) || view.substr(start.size()).starts_with('0'))
        return {};
    uint32_t number = 0;
    const char* const end = view.data() + view.size();
    const auto [at, error] = std::from_chars(view.data() + start.size(), end, number);
    if (error != std::errc() || at != end || number > most_shown_layers)
        return {};
    return number;
}

/// The number of the last sample that a pixel may have.
inline constexpr char last_sample = static_cast<char>('0' + sample_counts.back() - 1);

/// One sample of each pixel of a buffer.
struct SampleView {
    std::string_view buffer; ///< "final", "depth" or "normal"
    uint32_t sample = 0;     ///< in Vulkan's order, from 0
};

/// What "sample=N" (of the picture), "depth-sample=N" and "normal-sample=N" show, N: 0 … 3, the last that
/// a pixel may have. None for every other name.
inline std::optional<SampleView> sample_of_view(std::string_view view) {
    for (const auto& [start, buffer] : sample_view_starts)
        if (view.starts_with(start) && view.size() == start.size() + 1 && view.back() >= '0' &&
            view.back() <= last_sample)
            return SampleView{buffer, static_cast<uint32_t>(view.back() - '0')};
    return {};
}

/// Whether a renderer has the buffer: one of its `views`, "layer=N" where "layers" is one of them, or a single sample
/// of one of them, where it takes several a pixel.
inline bool has_view(const RendererInfo& info, std::string_view view) {
    const auto lists = [&](std::string_view name) {
        return std::find(info.views.begin(), info.views.end(), name) != info.views.end();
    };
    const auto sample = sample_of_view(view);
    const bool samples = std::any_of(info.settings.begin(), info.settings.end(),
                                     [](const SettingInfo& one) { return one.key.starts_with("msaa-"); });
    return lists(view) || (layer_of_view(view) && lists("layers")) || (sample && samples && lists(sample->buffer));
}

/// All that it has, for a line of text.
inline std::string names_of_views(const RendererInfo& info) {
    std::string names;
    for (const std::string& view : info.views)
        names += (names.empty() ? "" : ", ") + view;
    if (has_view(info, "layer=1"))
        names += ", layer=1 … layer=" + std::to_string(most_shown_layers);
    for (const auto& one : sample_view_starts) {
        const std::string start(one.first);
        if (has_view(info, start + "0"))
            names += ", " + start + "0 … " + start + last_sample;
    }
    return names;
}

} // namespace prelight
