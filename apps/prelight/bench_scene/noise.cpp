#include "noise.hpp"

#include <algorithm>
#include <cmath>

namespace prelight::app {
namespace {

constexpr double least_share = 0.02;

} // namespace

Figure figure_of(const Spread& times) {
    return {times.median, std::max(times.median - times.min, least_share * times.median)};
}

Figure operator/(const Figure& a, const Figure& b) {
    const double ratio = a.value / b.value;
    const double share = (a.value > 0 ? a.noise / a.value : 0) + b.noise / b.value;
    return {ratio, ratio * share};
}

std::string_view judgement_name(Judgement verdict) {
    switch (verdict) {
    case Judgement::within: return "within noise";
    case Judgement::beyond: return "beyond noise";
    case Judgement::unit_changed: return "F changed too";
    default: return "too few frames to tell";
    }
}

Judgement judge(const Figure& before, const Figure& after, uint32_t frames_before, uint32_t frames_after) {
    if (std::min(frames_before, frames_after) < least_frames)
        return Judgement::unknown;
    return std::abs(after.value - before.value) > before.noise + after.noise ? Judgement::beyond : Judgement::within;
}

} // namespace prelight::app
