#pragma once
#include "scene_source.hpp"

#include <filesystem>
#include <string>

namespace prelight::app {

/// `--environment` and what belongs to it, as text.
struct EnvironmentText {
    std::string file, intensity, rotation, background;
};

/// Adds the options; `option` is (names, target, word, help), as each command has it. A template, so that only
/// the units that parse include CLI11.
template <class Option>
void add_environment_options(const Option& option, EnvironmentText& text) {
    option("--environment", text.file, "NAME|FILE",
           "Light from all around: studio, none, or a picture twice as wide as high, .hdr, .exr or .png");
    option("--environment-intensity", text.intensity, "X", "Factor on the environment's light (default 1)");
    option("--environment-rotation", text.rotation, "DEGREES",
           "Turns it, counter-clockwise seen from above (default 0)");
    option("--background", text.background, "WHAT",
           "What is seen behind the scene: environment, a soft backdrop, or black (docs/environment.md)");
}

enum class Background { environment, backdrop, black };

/// The environment that a scene gets in place of its own, or what changes about its own.
struct EnvironmentChoice {
    std::string name;           ///< of a built-in one, or "none"; empty: a file, or nothing was said
    std::filesystem::path file; ///< empty: no file
    std::optional<float> intensity;
    std::optional<double> rotation; ///< radians
    std::optional<Background> background;
};

/// Throws UsageError.
EnvironmentChoice parse_environment(const EnvironmentText& text);

/// Gives a scene the environment. The file is read again when it has changed. `studio_where_dark`: a scene that is not
/// is_lit() gets the studio when nothing was chosen. The edit throws Error for a file that is no environment,
/// UsageError for a scene that has none to change.
SceneEdit environment_edit(const EnvironmentChoice& choice, bool studio_where_dark = false);

} // namespace prelight::app
