#include "figures.hpp"

#include <algorithm>

namespace prelight::app::viewer {

void Figures::add(const FrameFigures& frame, double shown_ms) {
    // Another architecture's passes are another plot.
    const auto same = [](const FrameFigures& a, const FrameFigures& b) {
        return std::ranges::equal(a.passes, b.passes, {}, &std::pair<std::string, double>::first,
                                  &std::pair<std::string, double>::first);
    };
    if (!frames_.empty() && !same(frames_.back().device, frame))
        frames_.clear();
    frames_.push_back({frame, shown_ms});
    if (frames_.size() > most)
        frames_.pop_front();
}

double Figures::shown_ms() const {
    std::vector<double> times;
    for (const Frame& frame : frames_)
        times.push_back(frame.shown_ms);
    if (times.empty())
        return 0;
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

} // namespace prelight::app::viewer
