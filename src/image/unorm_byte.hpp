#pragma once
#include <cstdint>

namespace prelight {

/// 0 … 1 in eight bits: clamped, rounded to the nearest, halves away from zero as std::lround() has them. NaN gives 0,
/// for its cast to an integer would be undefined.
inline uint8_t unorm_byte(float value) {
    const float scaled = value > 0 ? (value < 1 ? value * 255 : 255.0f) : 0.0f;
    const auto whole = static_cast<int32_t>(scaled);
    return static_cast<uint8_t>(whole + (scaled - static_cast<float>(whole) >= 0.5f));
}

} // namespace prelight
