#pragma once
#include <string_view>

namespace prelight::app {

// The files of apps/prelight/report/, embedded when the program is built.
extern const std::string_view report_html;
extern const std::string_view report_style;
extern const std::string_view report_script;

} // namespace prelight::app
