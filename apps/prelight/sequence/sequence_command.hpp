#pragma once
#include "sequence/frame_list.hpp"
#include "sequence/frame_rate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace prelight::app {

class Given;

/// What `prelight sequence` has beside the options of `render`.
struct SequenceOptions {
    std::string frames_text;        ///< as it was given
    std::vector<FrameRange> frames; ///< empty: all
    FrameRate rate;
    std::optional<double> turntable; ///< seconds for one round
    std::optional<double> loop;      ///< seconds for which animations begin again whenever they end
    std::optional<Shard> shard;
    bool skip_existing = false;
};

/// Throws UsageError.
SequenceOptions parse_sequence(const Given& given);

} // namespace prelight::app
