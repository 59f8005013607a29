#pragma once
#include "scene_source.hpp"

#include <filesystem>
#include <string>

namespace prelight::app {

class Given;

/// The last two are not of the scene, but of the picture: coverage.hpp makes them.
enum class Background { environment, backdrop, black, transparent, colour };

/// The environment that a scene gets in place of its own, or what changes about its own.
struct EnvironmentChoice {
    std::string name;           ///< of a built-in one, or "none"; empty: a file, or nothing was said
    std::filesystem::path file; ///< empty: no file
    std::optional<float> intensity;
    std::optional<double> rotation; ///< radians
    std::optional<Background> background;
    glm::vec3 colour{0}; ///< of Background::colour: sRGB-encoded, 0 … 1
    bool see_through() const { return background == Background::transparent || background == Background::colour; }
};

/// `--environment` and what belongs to it. Throws UsageError.
EnvironmentChoice parse_environment(const Given& given);

/// For commands other than `render`: throws UsageError where the background is see-through.
void refuse_see_through(const EnvironmentChoice& choice, const Given& given);

/// Gives a scene the environment. The file is read again when it has changed. `studio_where_dark`: a scene that is not
/// is_lit() gets the studio when nothing was chosen. The edit throws Error for a file that is no environment,
/// UsageError for a scene that has none to change.
SceneEdit environment_edit(const EnvironmentChoice& choice, bool studio_where_dark = false);

} // namespace prelight::app
