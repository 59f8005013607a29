#include "figures.hpp"

#include <algorithm>

namespace prelight::app::viewer {

void Figures::add(const FrameFigures& frame, std::optional<double> shown_ms) {
    if (shown_ms) {
        shown_.push_back(*shown_ms);
        if (shown_.size() > most)
            shown_.pop_front();
    }
    if (frame.passes.empty() || (!frames_.empty() && frames_.back().number == frame.number))
        return;
    // Another architecture's passes are another plot.
    const auto name = &std::pair<std::string, double>::first;
    if (!frames_.empty() && !std::ranges::equal(frames_.back().passes, frame.passes, {}, name, name))
        frames_.clear();
    frames_.push_back(frame);
    if (frames_.size() > most)
        frames_.pop_front();
}

double Figures::shown_ms() const {
    std::vector<double> times(shown_.begin(), shown_.end());
    if (times.empty())
        return 0;
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

} // namespace prelight::app::viewer
