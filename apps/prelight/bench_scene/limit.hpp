#pragma once
#include "measure.hpp"

namespace prelight::app {

/// How far a contender is from what the device can do, at one number of lights. Times in milliseconds;
/// what could not be measured is absent.
struct LimitFigures {
    const Run* run = nullptr;   ///< the contender's
    const Run* unit = nullptr;  ///< F at the same number of lights
    bool by_cpu = false;        ///< frames by CPU time instead of device time
    bool passes_by_cpu = false; ///< passes likewise
    double frame_ms = 0, unit_ms = 0;
    std::optional<double> no_lights_ms; ///< the frame without any light
    /// Geometry and material passes of the contender; none where a pass does more than that.
    std::optional<double> geometry_ms;
    std::optional<double> unit_pass_ms;         ///< F's pass by the clock of passes
    std::optional<double> light_ms, lists_ms;   ///< evaluating lights; building lists for that
    std::optional<double> perfect_ms, empty_ms; ///< the light pass over perfect and empty lists, fastest tile
    uint32_t perfect_tile = 0, empty_tile = 0;

    double frame_in_f() const { return frame_ms / unit_ms; }
    std::optional<double> geometry_in_f() const { return ratio(geometry_ms, unit_pass_ms); }
    std::optional<double> light_over_limit() const { return ratio(light_ms, perfect_ms); }
    std::optional<double> lists_over_light() const { return ratio(lists_ms, light_ms); }
    std::optional<double> no_lights_in_f() const { return ratio(no_lights_ms, unit_ms); }

    static std::optional<double> ratio(const std::optional<double>& a, const std::optional<double>& b) {
        return a && b && *b > 0 ? std::optional(*a / *b) : std::nullopt;
    }
};

/// `software`: the device's frames are compared by CPU time. `missing` gets a line for lists that are
/// called perfect and lack light: those are no limit.
std::vector<LimitFigures> limit_figures(const Measured& measured, const std::vector<Job>& jobs, bool software,
                                        std::vector<std::string>& missing);

} // namespace prelight::app
