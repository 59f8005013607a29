#include "first_sight.hpp"

#include "meter.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <prelight/exposure.hpp>

namespace prelight::app {
namespace {

/// Shares of a picture. Behind most scenes with lights of their own it is black.
constexpr double too_burnt = 0.25, too_black = 0.9;

long whole_percent(double share) { return std::lround(100 * share); }

/// With what was said about its intensity, rotation and background.
SceneEdit studio_edit(const EnvironmentChoice& choice) {
    EnvironmentChoice studio = choice;
    studio.name = "studio";
    return environment_edit(studio);
}

} // namespace

Exposure take_first_sight(const FirstSight& sight) {
    const bool lit_file = sight.lit_file && !sight.world.lights.empty() && sight.world.triangles > 0;
    const bool open_exposure = lit_file && sight.display && sight.exposure == ExposureChoice::open;
    const bool open_light =
        lit_file && sight.environment.name.empty() && sight.environment.file.empty() && !sight.world.scene->environment;
    const bool automatic = sight.exposure == ExposureChoice::automatic;
    Exposure exposure{sight.exposure == ExposureChoice::given ? sight.options.exposure : 0};
    if (!automatic && !open_exposure && !open_light)
        return exposure;
    Meter meter(sight.device, sight.camera, sight.options);
    meter.look(sight.world);
    if (open_light) {
        // A darker exposure makes the picture black, not the lights; with a brighter one they may be enough.
        const double black = meter.black(std::max(automatic ? meter.exposure() : exposure.ev, 0.0));
        if (black > too_black) {
            sight.edit(studio_edit(sight.environment));
            tell(fmt::format("environment: studio, since the file's lights leave {} % of the picture black "
                             "(--environment none keeps it so)",
                             whole_percent(black)));
            meter.look(sight.world);
        }
    }
    if (automatic || (open_exposure && meter.over_white() > too_burnt)) {
        exposure = {meter.exposure(), true};
        tell(fmt::format("exposure: auto is --exposure {:.1f}", exposure.ev));
    }
    return exposure;
}

void warn_of_extremes(const Log& log, const Image& display, const std::string& file, const World& world,
                      bool auto_exposure) {
    if (world.triangles == 0)
        return;
    const Extremes extremes = find_extremes(display);
    if (extremes.burnt > too_burnt)
        log.warning(fmt::format("{}: {} % of the pixels are burnt out: {}", file, whole_percent(extremes.burnt),
                                auto_exposure ? "try a lower --exposure than auto's" : "try --exposure auto"));
    else if (extremes.black > too_black)
        log.warning(fmt::format("{}: {} % of the pixels are black: {}{}", file, whole_percent(extremes.black),
                                world.scene->environment ? "try --background backdrop" : "try --environment studio",
                                auto_exposure ? "" : ", or --exposure auto"));
}

} // namespace prelight::app
