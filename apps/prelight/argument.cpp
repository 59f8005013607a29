#include "argument.hpp"

#include "output.hpp"
#include "sequence/video.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <platform/program/standard_streams.hpp>
#include <prelight/scene_io.hpp>
#include <prelight/views.hpp>

namespace prelight::app {
namespace {

/// The whole text as a number; false for anything else, a sign or a space included.
template <typename T>
bool whole_number(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && text.front() != '-';
}

/// Ascending, each once.
template <typename T>
void sort_once(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

[[noreturn]] void refuse(std::string_view option, const std::string& text, const std::string& reason) {
    throw UsageError(fmt::format("{} {}: {}", option, text.empty() ? "\"\"" : text, reason));
}

} // namespace

std::pair<uint32_t, uint32_t> parse_size(std::string_view option, const std::string& text) {
    uint32_t width = 0, height = 0;
    const size_t cross = text.find('x');
    if (cross == std::string::npos || !whole_number(std::string_view(text).substr(0, cross), width) ||
        !whole_number(std::string_view(text).substr(cross + 1), height))
        refuse(option, text, "not WIDTHxHEIGHT in pixels, as in 1280x720");
    if (width == 0 || height == 0)
        throw Error(fmt::format("{} {}: a picture without pixels", option, text));
    return {width, height};
}

uint32_t parse_count(std::string_view option, const std::string& text, uint32_t least) {
    uint32_t value = 0;
    if (!whole_number(text, value) || value < least)
        refuse(option, text,
               fmt::format("not a whole number from {} to {}", least, std::numeric_limits<uint32_t>::max()));
    return value;
}

std::vector<uint32_t> parse_light_counts(std::string_view option, const std::string& text) {
    std::vector<uint32_t> counts;
    if (text == "none")
        return counts;
    constexpr uint32_t most = 65536; // what a built-in scene can have
    for (size_t at = 0; at <= text.size();) {
        const size_t end = std::min(text.find(',', at), text.size());
        uint32_t count = 0;
        if (end == at || !whole_number(std::string_view(text).substr(at, end - at), count) || count == 0 ||
            count > most)
            refuse(option, text, fmt::format("not numbers from 1 to {}, as in 1,16,64, or none", most));
        counts.push_back(count);
        at = end + 1;
    }
    sort_once(counts);
    return counts;
}

uint64_t parse_seed(std::string_view option, const std::string& text) {
    uint64_t value = 0;
    if (!whole_number(text, value))
        refuse(option, text, "not a whole number of 64 bits");
    return value;
}

uint64_t parse_memory(std::string_view option, const std::string& text) {
    if (text.empty())
        return 0;
    constexpr std::string_view letters = "KMGT";
    std::string_view digits = text;
    const size_t letter = letters.find(static_cast<char>(std::toupper(static_cast<unsigned char>(text.back()))));
    if (letter != std::string_view::npos)
        digits.remove_suffix(1);
    const uint64_t shift = letter == std::string_view::npos ? 0 : 10 * (letter + 1);
    uint64_t value = 0;
    if (!whole_number(digits, value) || value == 0 || value > std::numeric_limits<uint64_t>::max() >> shift)
        refuse(option, text, "not a number of bytes, as in 512M or 4G");
    return value << shift;
}

double parse_number(std::string_view option, const std::string& text, double least, double most) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || value < least ||
        value > most)
        refuse(option, text, fmt::format("not a number from {} to {}", least, most));
    return value;
}

std::pair<std::string, std::string> parse_pair(std::string_view option, const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        refuse(option, text, "not of the form KEY=VALUE");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::optional<Moment> parse_moment(const std::string& time, const std::string& animation) {
    if (time.empty() && animation.empty())
        return {};
    Moment moment;
    if (!time.empty())
        moment.time = parse_number("--time", time, 0, 1e6);
    return moment;
}

Shading parse_shading(const std::string& text) {
    return parse_word<Shading>("--shading", text, {{"ggx", Shading::ggx}, {"phong", Shading::phong}});
}

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void refuse_pattern(std::string_view option, const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    const size_t percent = name.find('%');
    const size_t digits = percent == std::string::npos ? percent : name.find_first_not_of("0123456789", percent + 1);
    if (name.find("##") != std::string::npos || (digits != std::string::npos && name[digits] == 'd'))
        refuse(option, file.string(), "names a series of pictures: `prelight sequence` writes those");
}

std::vector<std::string> builtin_list() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtin_scenes())
        names.emplace_back(scene.name);
    return names;
}

std::string builtin_names() { return fmt::format("{}", fmt::join(builtin_list(), ", ")); }

void take_views(RenderCommand& command, const std::vector<std::string>& texts) {
    bool named = false;
    for (const std::string& text : texts) {
        // The name of a single layer or sample holds a = itself: layer=N, layer=N=FILE.
        size_t equals = text.find('=');
        if (text.starts_with(layer_view_start) ||
            std::ranges::any_of(sample_view_starts, [&](const auto& one) { return text.starts_with(one.first); }))
            equals = text.find('=', equals + 1);
        if (equals != std::string::npos) {
            if (equals == 0 || equals + 1 == text.size())
                refuse("--view", text, "not of the form BUFFER=FILE");
            command.more_views.push_back({text.substr(0, equals), text.substr(equals + 1)});
        } else if (named || text.empty()) {
            refuse("--view", text, "a second buffer needs a file of its own: BUFFER=FILE.png");
        } else {
            command.view = text;
            named = true;
        }
    }
    for (const ViewFile& more : command.more_views)
        command.options.views.push_back(more.view);
    const bool exr = lower_extension(command.output) == ".exr"; // of the final picture, before tone mapping
    command.options.views.push_back(exr ? "linear" : command.view);
    sort_once(command.options.views);
}

std::vector<std::filesystem::path> outputs_of(const RenderCommand& command) {
    std::vector<std::filesystem::path> files{command.output};
    for (const ViewFile& more : command.more_views)
        files.push_back(more.file);
    if (!command.stats.empty())
        files.push_back(command.stats);
    return files;
}

void check_endings(const RenderCommand& command, bool videos) {
    const std::string extension = lower_extension(command.output);
    const bool piped = is_standard_stream(command.output) && !videos;
    if (extension != ".png" && extension != ".exr" && !piped && !(videos && is_video(command.output)))
        refuse("-o", command.output.string(),
               videos ? "the name must end in .png, .exr, .mp4 or .mkv" : "the name must end in .png or .exr");
    // EXR holds scene-linear light, PNG what is drawn for the eye: neither suits the other's
    // values.
    const bool linear = command.view == "linear";
    if (extension == ".exr" && command.view != "final" && !linear)
        refuse("--view", command.view, "an EXR holds the final picture only; use .png");
    if (extension != ".exr" && linear)
        refuse("--view", command.view, "scene-linear values need a name ending in .exr");
    for (const ViewFile& more : command.more_views)
        if (lower_extension(more.file) != (more.view == "linear" ? ".exr" : ".png"))
            refuse("--view", more.view + "=" + more.file.string(),
                   more.view == "linear" ? "the name must end in .exr" : "the name must end in .png");
}

void check_outputs(const RenderCommand& command) {
    check_endings(command, false);
    refuse_pattern("-o", command.output);
    for (const ViewFile& more : command.more_views)
        refuse_pattern("--view", more.file);
    check_distinct(outputs_of(command), {});
}

} // namespace prelight::app
