#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <renderers/frame_queue.hpp>
#include <string>
#include <vector>

namespace prelight::app::viewer {

/// What the last pictures cost, for the plot.
class Figures {
public:
    /// What the device says of a frame, where that is news, and milliseconds from a picture's input to its being shown.
    void add(const FrameFigures& frame, std::optional<double> shown_ms);
    const std::deque<FrameFigures>& frames() const { return frames_; }
    /// Median of the last pictures.
    double shown_ms() const;

private:
    static constexpr size_t most = 120;
    std::deque<FrameFigures> frames_;
    std::deque<double> shown_;
};

} // namespace prelight::app::viewer
