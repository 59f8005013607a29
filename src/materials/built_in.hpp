#pragma once
#include <span>
#include <string_view>
#include <utility>

namespace prelight::materials {

/// The files of shaders/materials/ as they were when this was built: {name without ".glsl", text}, by name.
std::span<const std::pair<std::string_view, std::string_view>> built_in_sources();

} // namespace prelight::materials
