#pragma once
#include "environment_choice.hpp"
#include "log.hpp"

#include <functional>
#include <prelight/renderer.hpp>

namespace prelight::app {

/// What `--exposure` says. `open`: nothing.
enum class ExposureChoice { open, given, automatic };

/// A scene that is about to be drawn, and what the command line says of its light (docs/first-sight.md).
struct FirstSight {
    Device* device = nullptr; ///< null: the reference draws
    const World& world;
    const PlacedCamera& camera;
    const RenderOptions& options;
    ExposureChoice exposure = ExposureChoice::open;
    const EnvironmentChoice& environment;
    bool lit_file = false; ///< all lights are a file's own
    bool display = true;   ///< a picture for a display is made of it
    /// Does this to the world's scene, of which only the environment changes.
    std::function<void(const SceneEdit&)> edit;
};

/// The exposure, and who chose it.
struct Exposure {
    double ev = 0;
    bool automatic = false;
};

/// `--exposure auto`; and by itself, for a file with lights, `auto` where more than a quarter of its surfaces would be
/// brighter than white, and the studio where nine tenths of the picture would be black. Prints a line for each. Draws
/// nothing where nothing is open.
Exposure take_first_sight(const FirstSight& sight);

/// One warning where more than a quarter of a displayed picture is burnt out or nine tenths of it are black; says what
/// to do. None of a world without triangles, which has been told already.
void warn_of_extremes(const Log& log, const Image& display, const std::string& file, const World& world,
                      bool auto_exposure);

} // namespace prelight::app
