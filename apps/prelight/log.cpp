#include "log.hpp"

#include "terminal.hpp"

#include <cerrno>
#include <cstdio>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <system_error>

namespace prelight::app {
namespace {

bool quiet_process = false;

} // namespace

void set_quiet(bool quiet) { quiet_process = quiet; }

bool is_quiet() { return quiet_process; }

void tell(std::string_view line) {
    if (quiet_process)
        return;
    fmt::print("{}\n", escaped(line));
    if (std::fflush(stdout) != 0)
        throw std::system_error(errno, std::generic_category(), "standard output");
}

void Log::warning(std::string_view text) const { print(LogLevel::warning, "warning", text); }

void Log::note(std::string_view text) const { print(LogLevel::info, "note", text); }

void Log::print(LogLevel level, std::string_view prefix, std::string_view text) const {
    if (shows(level))
        fmt::print(stderr, "{} {}\n",
                   level == LogLevel::warning ? styled(stderr, Style::warning, fmt::format("{}:", prefix))
                                              : fmt::format("{}:", prefix),
                   escaped(text));
}

} // namespace prelight::app
