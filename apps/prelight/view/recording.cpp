#include "recording.hpp"

#include "../argument.hpp"

#include <fmt/format.h>
#include <platform/read_file.hpp>
#include <prelight/error.hpp>

namespace prelight::app::viewer {
namespace {

constexpr std::string_view first_line = "prelight view 1";
constexpr uint32_t last_step = 1u << 24; ///< three days
constexpr size_t most_events = size_t(1) << 22;

void take_size(Recording& recording, std::string_view line) {
    constexpr std::string_view key = "size ";
    if (!line.starts_with(key))
        throw Error("not size WxH");
    std::tie(recording.width, recording.height) = parse_size("size", std::string(line.substr(key.size())));
    if (std::max(recording.width, recording.height) > largest_side)
        throw Error(fmt::format("size: more than {} pixels a side", largest_side));
}

void take_event(Recording& recording, std::string_view line) {
    Event event = parse_event(line);
    if (event.step > last_step)
        throw Error(fmt::format("step {}: later than {}", event.step, last_step));
    if (!recording.events.empty() && event.step < recording.events.back().step)
        throw Error(fmt::format("step {}: after step {}", event.step, recording.events.back().step));
    if (recording.events.size() == most_events)
        throw Error(fmt::format("more than {} events", most_events));
    recording.events.push_back(std::move(event));
}

} // namespace

Recording parse_recording(std::string_view text, const std::string& name) {
    Recording recording;
    int parts = 0; // of the head that have come
    size_t number = 0;
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        if (line.empty() || line.starts_with('#'))
            continue;
        try {
            if (parts == 0 && line != first_line)
                throw Error(fmt::format("not a recording, which begins with \"{}\"", first_line));
            if (parts == 1)
                take_size(recording, line);
            if (parts >= 2)
                take_event(recording, line);
            parts = std::min(parts + 1, 2);
        } catch (const Error& error) {
            throw Error(fmt::format("{}: line {}: {}", name, number, error.what()));
        }
    }
    if (parts < 2)
        throw Error(fmt::format("{}: ends before its size", name));
    return recording;
}

Recording load_recording(const std::filesystem::path& file) {
    return parse_recording(read_text_file(file, largest_file::recording), file.string());
}

std::string recording_text(const Recording& recording) {
    std::string text = fmt::format("{}\nsize {}x{}\n", first_line, recording.width, recording.height);
    for (const Event& event : recording.events)
        text += event_line(event) + "\n";
    return text;
}

} // namespace prelight::app::viewer
