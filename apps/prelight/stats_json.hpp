#pragma once
#include "command_line.hpp"
#include "start_up.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace prelight::app {

/// One run's figures as `--stats`, `compare` and `bench` write them; times in milliseconds, memory in
/// bytes. `scene` and `renderer` are named as on the command line.
nlohmann::ordered_json stats_entry(const std::string& scene, const std::string& renderer, const RenderOptions& options,
                                   const Stats& stats);

/// JSON as a file's text. A file name may hold any bytes; JSON holds UTF-8 only, so that others are
/// replaced.
std::string json_text(const nlohmann::ordered_json& json);

/// The run's figures as `--stats` writes them; times in milliseconds, memory in bytes.
/// `warnings`: about the scene's file.
std::string stats_json(const RenderCommand& command, const Stats& stats, const StartUp& start_up,
                       const std::vector<std::string>& warnings);

} // namespace prelight::app
