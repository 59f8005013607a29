#pragma once
#include "command_line.hpp"
#include "sequence/plan.hpp"
#include "sequence/sequence_stats.hpp"
#include "start_up.hpp"

namespace prelight::app {

/// What a run of frames took.
struct SequenceFigures {
    SequenceStats stats;
    std::vector<double> interval_ms; ///< from the end of one frame's drawing to the end of the next
    double seconds = 0;              ///< from the first frame's beginning until all were written

    double frames_per_hour() const { return seconds > 0 ? stats.all().frames * 3600.0 / seconds : 0; }
};

/// `--stats`: as of one picture, with times over all frames, and `sequence`.
std::string sequence_json(const SequenceCommand& command, const SequencePlan& plan, const SequenceFigures& figures,
                          const StartUp& start_up, const std::vector<std::string>& warnings);

} // namespace prelight::app
