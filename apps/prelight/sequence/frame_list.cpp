#include "sequence/frame_list.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <unordered_set>

namespace prelight::app {
namespace {

[[noreturn]] void refuse_list(std::string_view option, const std::string& text, const std::string& reason) {
    throw UsageError(fmt::format("{} {}: {}", option, text.empty() ? "\"\"" : text, reason));
}

std::string_view without_spaces(std::string_view text) {
    while (text.starts_with(' '))
        text.remove_prefix(1);
    while (text.ends_with(' '))
        text.remove_suffix(1);
    return text;
}

/// Takes a whole number off the front of `text`; false when there is none.
bool take_number(std::string_view& text, uint32_t& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc())
        return false;
    text.remove_prefix(static_cast<size_t>(end - text.data()));
    return true;
}

bool take(std::string_view& text, char letter) {
    if (!text.starts_with(letter))
        return false;
    text.remove_prefix(1);
    return true;
}

/// "47", "1-30" or "1-100x3"; false for anything else.
bool take_range(std::string_view text, FrameRange& range) {
    if (!take_number(text, range.first))
        return false;
    range.last = range.first;
    range.single = true;
    if (take(text, '-')) {
        range.single = false;
        if (!take_number(text, range.last) || (take(text, 'x') && !take_number(text, range.step)))
            return false;
    }
    return text.empty();
}

uint64_t length_of(const FrameRange& range) { return uint64_t(range.last - range.first) / range.step + 1; }

} // namespace

std::vector<FrameRange> parse_frame_ranges(std::string_view option, const std::string& text) {
    std::vector<FrameRange> ranges;
    uint64_t frames = 0;
    for (size_t at = 0; at <= text.size();) {
        const size_t end = std::min(text.find(',', at), text.size());
        FrameRange range;
        if (!take_range(without_spaces(std::string_view(text).substr(at, end - at)), range))
            refuse_list(option, text, "not a list of frames, as in 47 or 0-29 or 3,5-10 or 0-99x3");
        if (range.last < range.first)
            refuse_list(option, text, fmt::format("{}-{} ends before it begins", range.first, range.last));
        if (range.step == 0)
            refuse_list(option, text, "a step of 0");
        if (range.last > last_frame_number)
            refuse_list(option, text, fmt::format("the largest number of a frame is {}", last_frame_number));
        frames += length_of(range);
        if (frames > most_frames)
            refuse_list(option, text, fmt::format("more than {} frames", most_frames));
        ranges.push_back(range);
        at = end + 1;
    }
    return ranges;
}

FrameNumbers frames_of(const std::vector<FrameRange>& ranges, uint32_t end) {
    FrameNumbers frames;
    std::unordered_set<uint32_t> seen;
    for (const FrameRange& range : ranges)
        for (uint64_t frame = range.first; frame <= range.last && (range.single || frame < end); frame += range.step)
            if (seen.insert(static_cast<uint32_t>(frame)).second)
                frames.push_back(static_cast<uint32_t>(frame));
    return frames;
}

std::string print_frames(const FrameNumbers& frames) {
    std::string text;
    for (size_t i = 0; i < frames.size();) {
        // As far as the step from the first to the second frame goes on.
        size_t end = i + 1;
        const uint32_t step = end < frames.size() && frames[end] > frames[i] ? frames[end] - frames[i] : 0;
        while (step > 0 && end < frames.size() && frames[end] > frames[end - 1] &&
               frames[end] - frames[end - 1] == step)
            ++end;
        text += (text.empty() ? "" : ",") + fmt::format("{}", frames[i]);
        if (end - i >= 3 || (end - i == 2 && step == 1)) {
            text += fmt::format("-{}", frames[end - 1]) + (step > 1 ? fmt::format("x{}", step) : "");
            i = end;
        } else {
            ++i;
        }
    }
    return text;
}

Shard parse_shard(std::string_view option, const std::string& text) {
    Shard shard;
    std::string_view rest = text;
    if (!take_number(rest, shard.index) || !take(rest, '/') || !take_number(rest, shard.count) || !rest.empty() ||
        shard.index < 1 || shard.index > shard.count)
        refuse_list(option, text, "not I/N, I from 1 to N, as in 2/6");
    return shard;
}

FrameNumbers shard_of(const FrameNumbers& frames, const Shard& shard) {
    FrameNumbers own;
    for (size_t i = shard.index - 1; i < frames.size(); i += shard.count)
        own.push_back(frames[i]);
    return own;
}

} // namespace prelight::app
