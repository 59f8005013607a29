#pragma once
#include "../command_line.hpp"

namespace prelight::app::viewer {

/// The window, until it is closed. Throws Error: also where this build has none.
void run_window(const ViewCommand& command);

} // namespace prelight::app::viewer
