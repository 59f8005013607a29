#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace prelight::app {

/// "#f80", "#ff8800" or a name of the sixteen of HTML 4 (and orange, gray, cyan, magenta): sRGB-encoded, 0 … 1. Absent
/// for another text.
std::optional<glm::vec3> find_colour(const std::string& text);
std::vector<std::string> colour_names();

} // namespace prelight::app
