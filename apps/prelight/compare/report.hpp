#pragma once
#include "command_line.hpp"

#include "time_budget.hpp"

#include <nlohmann/json_fwd.hpp>
#include <prelight/metrics.hpp>

namespace prelight::app {

/// What `compare` finds out about one variant.
struct RunReport {
    Variant variant;
    RendererInfo info;
    RenderOptions options;
    std::string error;        ///< why there are no figures; empty: there are
    bool wrong_usage = false; ///< the error is one of settings that do not go together
    std::string form;         ///< of the reference that its picture is judged against
    Comparison difference;
    std::map<std::string, std::string> pictures; ///< view, or "difference" → file below the folder
    Stats stats;                                 ///< with the scene's own lights
    bool in_series = false;                      ///< its time is measured against the number of lights too
    std::vector<Stats> series;                   ///< rising numbers of lights
    std::string stopped;                         ///< why the series ends early; empty: it does not
};

struct Report {
    CompareCommand command;
    std::string scene, camera, device, driver;
    std::string device_type; ///< as DeviceInfo::type
    /// On a software device whatever else the machine does lengthens wall and device time: CPU time is
    /// the figure to compare.
    bool software() const { return device_type == "software"; }
    uint64_t lights = 0, triangles = 0;
    uint64_t lights_added = 0; ///< scattered in a file's scene, among `lights`
    std::map<std::string, std::string> reference_pictures;
    double reference_ms = 0; ///< one picture, with Fresnel of each light, wall time
    std::vector<RunReport> runs;
    double seconds = 0; ///< for everything
    TimeBudget budget{};
    /// What --budget had no time for, one line each: frames, numbers of lights.
    std::vector<std::string> cut;
};

/// report.json: docs/compare.md describes it.
nlohmann::ordered_json report_json(const Report& report);

} // namespace prelight::app
