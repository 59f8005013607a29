#pragma once
#include "command_line.hpp"
#include "options/suggestion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <string_view>
#include <utility>

namespace prelight::app {

// Each turns the text of one argument into a value, or throws UsageError "OPTION TEXT: REASON".

/// "WxH", both 1 … 2³² − 1. Whether a device can do it is the renderer's to say.
std::pair<uint32_t, uint32_t> parse_size(std::string_view option, const std::string& text);
/// A whole decimal number, `least` … 2³² − 1.
uint32_t parse_count(std::string_view option, const std::string& text, uint32_t least);
/// "1,16,64": numbers of lights, 1 … 65,536, rising and each once; "none": no number.
std::vector<uint32_t> parse_light_counts(std::string_view option, const std::string& text);
/// A whole decimal number of 64 bits.
uint64_t parse_seed(std::string_view option, const std::string& text);
/// Bytes: a whole number above 0 with K, M, G or T (times 1,024 each), or none; 0 for an empty text.
uint64_t parse_memory(std::string_view option, const std::string& text);
/// A finite decimal number, `least` … `most`.
double parse_number(std::string_view option, const std::string& text, double least, double most);
/// "KEY=VALUE", neither empty.
std::pair<std::string, std::string> parse_pair(std::string_view option, const std::string& text);

/// Any animation that is named moves the scene off its rest, at 0 s when no time is given.
std::optional<Moment> parse_moment(const std::string& time, const std::string& animation);
Shading parse_shading(const std::string& text);

template <typename T>
T parse_word(std::string_view option, const std::string& text,
             const std::vector<std::pair<std::string_view, T>>& words) {
    std::vector<std::string> known;
    for (const auto& [word, value] : words) {
        if (word == text)
            return value;
        known.emplace_back(word);
    }
    throw UsageError(
        fmt::format("{} {}: not one of {}{}", option, text, fmt::join(known, ", "), did_you_mean(text, known)));
}

/// The extension in lower case, with its dot.
std::string lower_extension(const std::filesystem::path& path);
/// The built-in scenes.
std::vector<std::string> builtin_list();
/// "city, lights, …" for messages.
std::string builtin_names();

/// Sorts the texts of --view into the command: the buffer for `output`, and those with files.
void take_views(RenderCommand& command, const std::vector<std::string>& texts);
/// Throws UsageError for a name like "f-%03d.png" or "f.####.png".
void refuse_pattern(std::string_view option, const std::filesystem::path& file);
/// All files that the command writes.
std::vector<std::filesystem::path> outputs_of(const RenderCommand& command);
/// Each picture has an extension that suits its content; `videos`: or that of a video. Throws UsageError.
void check_endings(const RenderCommand& command, bool videos);
/// Each output has an extension that suits its content, and no two outputs are one file.
void check_outputs(const RenderCommand& command);

} // namespace prelight::app
