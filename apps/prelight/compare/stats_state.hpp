#pragma once
#include <nlohmann/json_fwd.hpp>
#include <prelight/renderer.hpp>

namespace prelight::app {

/// Every figure of a run, so that another process can go on with it. (What --stats writes is for people: it names and
/// leaves out.)
nlohmann::json stats_state(const Stats& stats);
/// Throws nlohmann::json::exception for what stats_state() did not make.
Stats stats_from_state(const nlohmann::json& state);

} // namespace prelight::app
