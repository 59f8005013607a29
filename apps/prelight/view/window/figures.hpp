#pragma once
#include <cstdint>
#include <deque>
#include <renderers/frame_queue.hpp>
#include <string>
#include <vector>

namespace prelight::app::viewer {

/// What the last pictures cost, for the plot.
class Figures {
public:
    /// A picture that was drawn: what the device says of it, and the milliseconds from its input to its being shown.
    void add(const FrameFigures& frame, double shown_ms);
    void clear() { frames_.clear(); }

    struct Frame {
        FrameFigures device;
        double shown_ms = 0;
    };
    const std::deque<Frame>& frames() const { return frames_; }
    /// Median of the last pictures.
    double shown_ms() const;

private:
    static constexpr size_t most = 120;
    std::deque<Frame> frames_;
};

} // namespace prelight::app::viewer
