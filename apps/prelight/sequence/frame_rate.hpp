#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace prelight::app {

/// Frames a second, as ffmpeg takes them too: 30, 23.976, 30000/1001.
struct FrameRate {
    double numerator = 30, denominator = 1;
    std::string text = "30"; ///< as it was given

    /// Seconds at which a frame is: one division, so that frame 3 at 30 a second is at 0.1 as that is written.
    double time_of(uint32_t frame) const { return frame * denominator / numerator; }
    double per_second() const { return numerator / denominator; }
};

/// `--fps`: 0.001 … 1000. Throws UsageError.
FrameRate parse_frame_rate(std::string_view option, const std::string& text);

} // namespace prelight::app
