#pragma once
#include "limit.hpp"

namespace prelight::app {

/// The figures of every contender at one number of lights, on stdout.
void print_runs(const Measured& measured, const Stop& stop, const std::vector<LimitFigures>& limits);
/// What --limit measured there.
void print_limits(const Stop& stop, const std::vector<LimitFigures>& limits);

} // namespace prelight::app
