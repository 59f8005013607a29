#pragma once
#include "command_line.hpp"

namespace prelight::app {

class Given;

/// `bench` takes a scene, a table's name or `report`, and what goes with one does not go with the others. Throws
/// UsageError.
BenchCommand parse_bench(const Given& given);

} // namespace prelight::app
