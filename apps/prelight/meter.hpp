#pragma once
#include "log.hpp"

#include <prelight/renderer.hpp>

namespace prelight::app {

/// What `--exposure auto` is for this picture: its surfaces' luminances, metered in a small picture of the same scene.
/// By the light pre-pass, whichever architecture draws it in the end, so that all get the same; without a device by the
/// reference. `options` are the command's: their shading, and whether there are shadows and ambient occlusion, count
/// too.
double meter_exposure(Device* device, const World& world, const PlacedCamera& camera, const RenderOptions& options);

/// The line that `--exposure auto` prints.
void print_exposure(double ev);

/// One warning where more than a quarter of a displayed picture is burnt out or black; says what to do. None of a world
/// without triangles, which has been told already.
void warn_of_extremes(const Log& log, const Image& display, const std::string& file, const World& world,
                      bool auto_exposure);

} // namespace prelight::app
