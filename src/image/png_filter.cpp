// Compiled with -O3 (src/CMakeLists.txt), for the compiler to filter 16 bytes at once.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <image/png_filter.hpp>
#include <limits>

namespace prelight {
namespace {

enum Filter : uint8_t { none, sub, up, average, paeth }; ///< https://www.w3.org/TR/png-3/#9Filter-types
constexpr std::array filters{none, sub, up, average, paeth};

template <Filter filter>
uint8_t filtered(uint8_t byte, int left, int above, int corner) {
    int guess = 0;
    if constexpr (filter == sub)
        guess = left;
    else if constexpr (filter == up)
        guess = above;
    else if constexpr (filter == average)
        guess = (left + above) / 2;
    else if constexpr (filter == paeth) {
        const int a = std::abs(above - corner), b = std::abs(left - corner), c = std::abs(left + above - 2 * corner);
        guess = a <= b && a <= c ? left : b <= c ? above : corner;
    }
    return static_cast<uint8_t>(byte - guess);
}

template <Filter filter>
void filter_row(std::span<const uint8_t> row, std::span<const uint8_t> above, size_t pixel_bytes, uint8_t* to) {
    const size_t size = row.size();
    for (size_t i = 0; i < pixel_bytes; ++i)
        to[i] = filtered<filter>(row[i], 0, above[i], 0);
    const uint8_t *here = row.data() + pixel_bytes, *left = row.data();
    const uint8_t *over = above.data() + pixel_bytes, *corner = above.data();
    uint8_t* __restrict out = to + pixel_bytes;
    for (size_t i = 0; i < size - pixel_bytes; ++i)
        out[i] = filtered<filter>(here[i], left[i], over[i], corner[i]);
}

void filter_by(Filter filter, std::span<const uint8_t> row, std::span<const uint8_t> above, size_t pixel_bytes,
               uint8_t* to) {
    switch (filter) {
    case none: return filter_row<none>(row, above, pixel_bytes, to);
    case sub: return filter_row<sub>(row, above, pixel_bytes, to);
    case up: return filter_row<up>(row, above, pixel_bytes, to);
    case average: return filter_row<average>(row, above, pixel_bytes, to);
    case paeth: return filter_row<paeth>(row, above, pixel_bytes, to);
    }
}

/// Of bytes as −128 … 127. In parts, whose sums fit into 32 bits.
uint64_t sum_of_magnitudes(std::span<const uint8_t> bytes) {
    constexpr size_t part = size_t(1) << 20;
    uint64_t sum = 0;
    for (size_t from = 0; from < bytes.size(); from += part) {
        uint32_t of_part = 0;
        for (const uint8_t byte : bytes.subspan(from, std::min(part, bytes.size() - from)))
            of_part += static_cast<uint32_t>(std::abs(static_cast<int8_t>(byte)));
        sum += of_part;
    }
    return sum;
}

} // namespace

void PngRowFilter::operator()(std::span<const uint8_t> row, std::span<const uint8_t> above, std::span<uint8_t> out) {
    tried_.resize(row.size());
    uint64_t least = std::numeric_limits<uint64_t>::max();
    for (const Filter filter : filters) {
        filter_by(filter, row, above, pixel_bytes_, tried_.data());
        const uint64_t sum = sum_of_magnitudes(tried_);
        if (sum >= least)
            continue;
        least = sum;
        out[0] = filter;
        std::ranges::copy(tried_, out.begin() + 1);
    }
}

} // namespace prelight
