#pragma once
#include "command_line.hpp"

#include <string>

namespace prelight::app {

/// The run's figures as `--stats` writes them; times in milliseconds, memory in bytes.
std::string stats_json(const RenderCommand& command, const Stats& stats);

} // namespace prelight::app
