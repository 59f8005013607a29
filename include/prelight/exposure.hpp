#pragma once
#include <optional>
#include <prelight/export.hpp>
#include <prelight/image.hpp>
#include <vector>

namespace prelight {

/// The exposure in EV that suits a scene-linear picture, from the luminances of the pixels that count (`surface`, as
/// many as there are pixels; where none counts, all of them). The mean of their logarithms becomes middle grey, 0.18:
/// Reinhard and others, "Photographic Tone Reproduction for Digital Images", 2002. Where the brightest fiftieth would
/// then exceed 1, the picture stays darker, by two stops at most: a street at night has bright lights and remains
/// night. Rounded to tenths; absent for a black picture. Twice the light gives one EV less. What is infinite counts as
/// the largest half float, 65,504.
PRELIGHT_API std::optional<double> auto_exposure(const Image& linear, const std::vector<bool>& surface);

/// How much of a picture has lost its values.
struct Extremes {
    /// Share of the pixels with a channel at 253/255 or more: what pbr-neutral makes of four times white.
    double burnt = 0;
    double black = 0; ///< share of those below 1/255 in all channels
};
/// Counts them in a display-encoded picture, values 0 … 1.
PRELIGHT_API Extremes find_extremes(const Image& display);

} // namespace prelight
