#pragma once
#include <chrono>
#include <limits>
#include <optional>

namespace prelight::app {

/// `--budget`: wall time that a command may take, from when this was made.
class TimeBudget {
public:
    explicit TimeBudget(std::optional<double> seconds = {}) : seconds_(seconds) {}
    std::optional<double> seconds() const { return seconds_; } ///< absent: as long as it takes
    double spent() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    /// Below 0 when it is over; infinite without a limit.
    double left() const { return seconds_ ? *seconds_ - spent() : std::numeric_limits<double>::infinity(); }

private:
    std::optional<double> seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace prelight::app
