#include "sequence/sequence_command.hpp"

#include "argument.hpp"

namespace prelight::app {

void finish(SequenceOptions& options, const SequenceText& text) {
    options.frames_text = text.frames;
    if (text.frames != "all")
        options.frames = parse_frame_ranges("--frames-at", text.frames);
    options.rate = parse_frame_rate("--fps", text.rate);
    if (!text.turntable.empty())
        options.turntable = parse_number("--turntable", text.turntable, 0.001, 1e6);
    if (!text.loop.empty())
        options.loop = parse_number("--loop", text.loop, 0.001, 1e6);
    if (!text.shard.empty())
        options.shard = parse_shard("--shard", text.shard);
}

} // namespace prelight::app
