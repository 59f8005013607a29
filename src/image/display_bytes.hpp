#pragma once
#include <cstdint>
#include <prelight/image.hpp>
#include <vector>

namespace prelight {

/// RGB, a byte a channel, row by row: display-encoded values in 0 … 1, clamped and rounded to nearest, NaN as 0. What a
/// PNG of the picture holds.
std::vector<uint8_t> display_bytes(const Image& display);

} // namespace prelight
