#pragma once
#include "../command_line.hpp"

namespace prelight::app::viewer {

/// `view --play FILE`: the recording's steps, without a window, and the picture at their end. Throws Error.
void play(const ViewCommand& command);

} // namespace prelight::app::viewer
