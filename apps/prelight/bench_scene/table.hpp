#pragma once
#include "limit.hpp"

namespace prelight::app {

/// The figures of every contender at every number of lights, on stdout.
void print_runs(const Measured& measured, const std::vector<LimitFigures>& limits);
/// What --limit measured.
void print_limits(const std::vector<LimitFigures>& limits, const std::vector<std::string>& missing);

} // namespace prelight::app
