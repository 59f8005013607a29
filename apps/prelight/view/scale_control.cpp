#include "scale_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace prelight::app::viewer {
namespace {

// Few steps: each change makes images anew.
constexpr std::array scales{1.0, 0.7, 0.5, 0.35, 0.25};
constexpr double too_long = 40, short_enough = 33; // ms a picture
constexpr double settled = 0.4;                    // seconds

} // namespace

std::optional<double> ScaleControl::moving(double picture_ms, double scale) {
    if (++since_change_ == 1) // the first after a change builds things
        return {};
    smoothed_ = since_change_ == 2 ? picture_ms : 0.7 * smoothed_ + 0.3 * picture_ms;
    if (since_change_ < 4)
        return {};
    for (size_t i = 0; i < scales.size(); ++i) {
        if (std::abs(scales[i] - scale) > 1e-6)
            continue;
        const bool down = smoothed_ > too_long && i + 1 < scales.size();
        // What the next larger one is likely to take, by its pixels.
        const bool up = i > 0 && smoothed_ * std::pow(scales[i - 1] / scale, 2) < short_enough * 0.8;
        if (!down && !up)
            return {};
        since_change_ = 0;
        return down ? scales[i + 1] : scales[i - 1];
    }
    since_change_ = 0;
    return scales[0];
}

std::optional<double> ScaleControl::still(double seconds, double scale) const {
    if (seconds < settled || scale == 1)
        return {};
    return 1.0;
}

} // namespace prelight::app::viewer
