#pragma once
#include "kept_steps.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "scene_series.hpp"

namespace prelight::app {

/// Times every run that has no error with the scene's own lights (`world`), and those in the series with each of
/// the command's light counts, all runs interleaved: fills `stats` (keeping the pairs), `series` and
/// `stopped`, or `error`. A number of lights that a process before has timed whole is found again. Shows progress from
/// `share` to 1. Throws Error when the scene cannot be made.
void take_times(Report& report, Device& device, const SceneSeries& scenes, const World& world, KeptSteps& kept,
                Progress& progress, double share);

/// The camera that the command names, or the first.
const PlacedCamera& camera_of(const World& world, const std::string& name);

} // namespace prelight::app
