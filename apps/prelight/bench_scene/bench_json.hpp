#pragma once
#include "limit.hpp"

#include <nlohmann/json.hpp>

namespace prelight::app {

/// An entry of "runs": as --stats has it, with the variant and the number of lights that was asked for.
nlohmann::ordered_json run_json(const std::string& scene, const Run& run);
/// The object "limit": docs/bench.md describes it.
nlohmann::ordered_json limit_json(const std::string& scene, const Measured& measured,
                                  const std::vector<LimitFigures>& figures, const std::vector<std::string>& missing);

} // namespace prelight::app
