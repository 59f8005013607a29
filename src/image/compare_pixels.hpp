#pragma once
#include <prelight/metrics.hpp>

namespace prelight {

/// What `compare` looks at: both pictures exposed alike and encoded for a display.
struct DisplayedPair {
    Image picture, reference;
};

/// As `compare`, without FLIP, which takes most of its time: `flip` stays 0.
Comparison compare_pixels(const Image& picture, const Image& reference, std::span<const uint8_t> left_out = {},
                          DisplayedPair* displayed = nullptr);

} // namespace prelight
