#pragma once
#include <chrono>
#include <utility>

namespace prelight::app {

/// Where the time from the command to its first picture goes: wall time, milliseconds.
struct StartUp {
    double device = 0;  ///< the device and the renderer are made
    double scene = 0;   ///< from then on, until the scene is there: what it costs the picture
    double world = 0;   ///< geometry, textures and pipelines come onto the device
    double frames = 0;  ///< the warm-up and the frames
    double picture = 0; ///< read back and written
    double total() const { return device + scene + world + frames + picture; }
};

/// Measures one stretch after the other.
class Stopwatch {
public:
    /// Milliseconds since the last lap, or since this was made.
    double lap() {
        const auto before = std::exchange(last_, Clock::now());
        return std::chrono::duration<double, std::milli>(last_ - before).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

} // namespace prelight::app
