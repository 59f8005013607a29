#include "sequence/sequence_json.hpp"

#include "stats_json.hpp"

#include <nlohmann/json.hpp>

namespace prelight::app {

std::string sequence_json(const SequenceCommand& command, const SequencePlan& plan, const SequenceFigures& figures,
                          const StartUp& start_up, const std::vector<std::string>& warnings) {
    nlohmann::ordered_json entry =
        stats_entry(command.render.scene, command.render.renderer, command.render.options, figures.stats.all());
    const Spread interval = spread(figures.interval_ms);
    entry["sequence"] = {{"frames", print_frames(plan.wanted)},
                         {"drawn", plan.to_draw.size()},
                         {"skipped", plan.existing.size()},
                         {"fps", command.sequence.rate.per_second()},
                         {"seconds", figures.seconds},
                         {"frames_per_hour", figures.frames_per_hour()},
                         {"interval_ms", {{"min", interval.min}, {"median", interval.median}, {"max", interval.max}}}};
    entry["start_up_ms"] = {{"device", start_up.device}, {"scene", start_up.scene}};
    entry["warnings"] = warnings;
    return json_text(entry);
}

} // namespace prelight::app
