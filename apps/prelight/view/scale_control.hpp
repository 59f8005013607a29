#pragma once
#include <optional>

namespace prelight::app::viewer {

/// `--scale auto`: fewer pixels where pictures that move take too long, all of them again where it stands still.
class ScaleControl {
public:
    /// After a picture that took so long. The scale that is better from now on; absent: this one.
    std::optional<double> moving(double picture_ms, double scale);
    /// Nothing has changed for `seconds`.
    std::optional<double> still(double seconds, double scale) const;

private:
    double smoothed_ = 0;
    int since_change_ = 0; ///< pictures
};

} // namespace prelight::app::viewer
