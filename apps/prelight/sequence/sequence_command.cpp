#include "sequence/sequence_command.hpp"

#include "argument.hpp"
#include "options/given.hpp"

namespace prelight::app {

SequenceOptions parse_sequence(const Given& given) {
    SequenceOptions options{.frames_text = given.text("--frames-at", "all"),
                            .rate = parse_frame_rate("--fps", given.text("--fps", "30"))};
    if (options.frames_text != "all")
        options.frames = parse_frame_ranges("--frames-at", options.frames_text);
    if (given.has("--turntable"))
        options.turntable = parse_number("--turntable", given.text("--turntable"), 0.001, 1e6);
    if (given.has("--loop"))
        options.loop = parse_number("--loop", given.text("--loop"), 0.001, 1e6);
    if (given.has("--shard"))
        options.shard = parse_shard("--shard", given.text("--shard"));
    options.skip_existing = given.has("--skip-existing");
    return options;
}

} // namespace prelight::app
