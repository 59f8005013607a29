#include "log.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {

void Log::warning(std::string_view text) const { print(LogLevel::warning, "warning", text); }

void Log::note(std::string_view text) const { print(LogLevel::info, "note", text); }

void Log::print(LogLevel level, std::string_view prefix, std::string_view text) const {
    if (shows(level))
        fmt::print(stderr, "{}: {}\n", prefix, escaped(text));
}

} // namespace prelight::app
