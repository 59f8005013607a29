#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>

namespace prelight::app {

/// A line of standard output for each frame, flushed: what a farm shows of a task that runs. From any thread.
class FrameLines {
public:
    /// `frames` will be drawn, from now on.
    explicit FrameLines(size_t frames);
    /// "out.0012.png: frame 12, 13 of 60, about 0:42 left". Throws std::system_error when it cannot be printed.
    void done(uint32_t frame, const std::filesystem::path& file);
    double seconds() const; ///< since the beginning

private:
    using Clock = std::chrono::steady_clock;
    const size_t frames_;
    const Clock::time_point start_ = Clock::now();
    std::mutex mutex_;
    size_t done_ = 0;
    double first_ = 0; ///< seconds() when one was done
};

} // namespace prelight::app
