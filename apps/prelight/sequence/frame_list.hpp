#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::app {

/// Numbers of frames, in the order in which they are drawn, each once.
using FrameNumbers = std::vector<uint32_t>;

/// The largest number of a frame, and the most frames that one list may have.
constexpr uint32_t last_frame_number = 99'999'999, most_frames = 1'000'000;

/// A part of a list: `first`, `first + step` … up to `last`.
struct FrameRange {
    uint32_t first = 0, last = 0, step = 1;
    bool single = false; ///< written as one number, not as a range
    bool operator==(const FrameRange&) const = default;
};

/// `--frames-at`: "47", "1-30", "3, 5-10", "1-100x3" (every third). Throws UsageError: not of that form, a range that
/// ends before it begins, a number above last_frame_number, more than most_frames.
std::vector<FrameRange> parse_frame_ranges(std::string_view option, const std::string& text);

/// The ranges' numbers; one that was there already is left out. Of a range what lies at or beyond `end` is left out
/// too, but not a number that stands by itself.
FrameNumbers frames_of(const std::vector<FrameRange>& ranges, uint32_t end = last_frame_number + 1);

/// The shortest way to write them in their order that this knows; empty for none.
std::string print_frames(const FrameNumbers& frames);

/// `--shard I/N`: the I-th of N tasks, I from 1.
struct Shard {
    uint32_t index = 1, count = 1;
};
/// Throws UsageError.
Shard parse_shard(std::string_view option, const std::string& text);

/// Every N-th frame of the list, from the I-th on: neighbours take about as long as each other, so that tasks get even
/// shares where frames become slower along the sequence. Empty where there are fewer frames than I.
FrameNumbers shard_of(const FrameNumbers& frames, const Shard& shard);

} // namespace prelight::app
