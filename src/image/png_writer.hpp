#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace prelight {

/// The bytes of an 8-bit PNG; the same pixels give the same bytes. `channels`: 1 grey, 2 grey and alpha, 3 RGB or 4
/// RGBA. `pixels`: width × height × channels bytes, row by row from the top. Throws std::invalid_argument where that
/// does not fit, std::bad_alloc.
std::vector<std::byte> encode_png(uint32_t width, uint32_t height, uint32_t channels, std::span<const uint8_t> pixels);

} // namespace prelight
