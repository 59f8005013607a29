#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace prelight::gltf {

/// Where a text stops being JSON, for a message: "line 3, column 7"; empty when it does not.
std::string place_of_mistake(std::span<const uint8_t> text);

} // namespace prelight::gltf
