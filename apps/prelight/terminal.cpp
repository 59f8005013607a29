#include "terminal.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <platform/program/terminal.hpp>

namespace prelight::app {

bool may_style(bool terminal, const char* no_color, const char* term) {
    const bool asked_not_to = no_color && *no_color;
    return terminal && !asked_not_to && term && *term && std::string_view(term) != "dumb";
}

std::string styled(std::FILE* stream, Style style, std::string_view text) {
    if (!may_style(is_terminal(stream), std::getenv("NO_COLOR"), std::getenv("TERM")))
        return std::string(text);
    const char* code = style == Style::heading ? "1" : style == Style::warning ? "33" : "31";
    return fmt::format("\033[{}m{}\033[0m", code, text);
}

} // namespace prelight::app
