#pragma once
#include <map>
#include <string>

namespace prelight {

/// The configurations of the source texts of the light pre-pass: preset → settings.
std::map<std::string, std::map<std::string, std::string>> light_prepass_presets();

} // namespace prelight
