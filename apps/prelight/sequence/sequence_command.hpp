#pragma once
#include "sequence/frame_list.hpp"
#include "sequence/frame_rate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace prelight::app {

/// What `prelight sequence` has beside the options of `render`, as text.
struct SequenceText {
    std::string frames = "all", rate = "30", turntable, loop, shard;
};

/// The same, checked.
struct SequenceOptions {
    std::string frames_text;        ///< as it was given
    std::vector<FrameRange> frames; ///< empty: all
    FrameRate rate;
    std::optional<double> turntable; ///< seconds for one round
    std::optional<double> loop;      ///< seconds for which animations begin again whenever they end
    std::optional<Shard> shard;
    bool skip_existing = false;
};

/// Adds the options, as add_environment_options() does.
template <class Sub, class Option>
void add_sequence_options(Sub& sub, const Option& option, SequenceText& text, SequenceOptions& options) {
    option("--frames-at", text.frames, "LIST", "Frames to draw: all (default), 47, 0-29, 3,5-10, 0-99x3, ...");
    option("--fps", text.rate, "F", "Frames a second: frame f shows the time f/F (default 30)");
    option("--turntable", text.turntable, "SECONDS", "The camera goes round the scene, once in so many seconds");
    option("--loop", text.loop, "SECONDS", "The animations begin again whenever they end, for so many seconds");
    sub.add_flag("--skip-existing", options.skip_existing, "Leave out frames whose files are there and whole");
    option("--shard", text.shard, "I/N", "Draw every N-th frame of the list, from the I-th on (I from 1)");
}

/// Throws UsageError.
void finish(SequenceOptions& options, const SequenceText& text);

} // namespace prelight::app
