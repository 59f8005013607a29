#include "sequence/frame_lines.hpp"

#include "log.hpp"
#include "progress.hpp"

#include <fmt/format.h>

namespace prelight::app {

FrameLines::FrameLines(size_t frames) : frames_(frames) {}

double FrameLines::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

void FrameLines::done(uint32_t frame, const std::filesystem::path& file) {
    const std::lock_guard lock(mutex_);
    const double now = seconds();
    if (done_++ == 0)
        first_ = now;
    // The first one made pipelines: it says nothing of the others.
    const double each = done_ > 1 ? (now - first_) / double(done_ - 1) : now;
    const double left = each * double(frames_ - done_);
    tell(fmt::format("{}: frame {}, {} of {}{}", file.string(), frame, done_, frames_,
                     done_ < frames_ ? fmt::format(", about {} left", clock_text(left)) : ""));
}

} // namespace prelight::app
