#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace prelight {

/// Filters one row of an 8-bit PNG by that one of the five filters which leaves the smallest sum of absolute
/// differences (PNG, 12.7: "Filter selection"). `row` and the row `above` it: `pixel_bytes` (1 … 4) a pixel; above the
/// first row are zeros. `out`: one byte more, the filter's number first.
class PngRowFilter {
public:
    explicit PngRowFilter(uint32_t pixel_bytes) : pixel_bytes_(pixel_bytes) {}
    void operator()(std::span<const uint8_t> row, std::span<const uint8_t> above, std::span<uint8_t> out);

private:
    uint32_t pixel_bytes_;
    std::vector<uint8_t> tried_;
};

} // namespace prelight
