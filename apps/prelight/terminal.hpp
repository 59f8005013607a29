#pragma once
#include <cstdio>
#include <string>
#include <string_view>

namespace prelight::app {

enum class Style { heading, warning, failure };

/// Whether text may be styled there: a terminal, which is not a dumb one, and NO_COLOR is not set (no-color.org).
bool may_style(bool terminal, const char* no_color, const char* term);

/// The text, in the style where the stream may show it.
std::string styled(std::FILE* stream, Style style, std::string_view text);

} // namespace prelight::app
