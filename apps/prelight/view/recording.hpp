#pragma once
#include "event.hpp"

#include <filesystem>

namespace prelight::app::viewer {

/// What `--record` writes and `--play` reads: the window's size at the start, and all events in their order. A text
/// file: "prelight view 1", "size WxH", then a line an event; empty lines and those that begin with # count for
/// nothing.
struct Recording {
    uint32_t width = 1280, height = 720; ///< pixels
    std::vector<Event> events;           ///< by step, ascending
};

/// The file's text. Throws Error "NAME: line N: REASON".
Recording parse_recording(std::string_view text, const std::string& name);
/// Reads a file of at most 64 MiB. Throws Error.
Recording load_recording(const std::filesystem::path& file);
std::string recording_text(const Recording& recording);

} // namespace prelight::app::viewer
