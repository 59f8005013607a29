#pragma once
#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <string>
#include <vector>

namespace prelight {

/// Of sample_counts those above `least`, as words: {"2", "4"}.
inline std::vector<std::string> sample_counts_above(uint32_t least) {
    std::vector<std::string> words;
    for (const uint32_t count : sample_counts)
        if (count > least)
            words.push_back(std::to_string(count));
    return words;
}

/// Throws UsageError naming those there are.
inline void check_sample_count(uint32_t samples) {
    if (std::find(sample_counts.begin(), sample_counts.end(), samples) == sample_counts.end())
        throw UsageError(fmt::format("--msaa {}: not one of {}", samples, fmt::join(sample_counts, ", ")));
}

} // namespace prelight
