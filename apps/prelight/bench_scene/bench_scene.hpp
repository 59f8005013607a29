#pragma once
#include "command_line.hpp"

namespace prelight::app {

/// `prelight bench SCENE`. Throws Error, UsageError.
void bench_scene(const BenchCommand& command);
/// `prelight bench report FILE… -o PAGE`. Throws Error.
void bench_report(const BenchCommand& command);

} // namespace prelight::app
