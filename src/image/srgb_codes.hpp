#pragma once
#include <array>
#include <cstdint>

namespace prelight {

/// Linear light, 0 … 1, of each 8-bit sRGB code.
const std::array<float, 256>& srgb_linear();

} // namespace prelight
