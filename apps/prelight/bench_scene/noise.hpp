#pragma once
#include <prelight/renderer.hpp>
#include <string_view>

namespace prelight::app {

/// A measured value and how far it may be off without anything having changed, in its own unit.
struct Figure {
    double value = 0;
    double noise = 0;
};

/// The median of a time. What else a machine does only lengthens times, so the way from the fastest
/// frame to the median is what frames differ by; a slow frame now and then is not. At least 2 %.
Figure figure_of(const Spread& times);
/// One over the other; the shares that each may be off add up. `b.value` > 0.
Figure operator/(const Figure& a, const Figure& b);

enum class Judgement {
    within,
    beyond,
    unknown,     ///< too few frames
    unit_changed ///< so did F, which has nothing to do with it: the machine is not what it was
};
/// "within noise", "beyond noise", "too few frames to tell", "F changed too".
std::string_view judgement_name(Judgement verdict);

/// Below this a spread says nothing.
constexpr uint32_t least_frames = 5;
/// Beyond noise: the two values are further apart than both may be off together.
Judgement judge(const Figure& before, const Figure& after, uint32_t frames_before, uint32_t frames_after);

} // namespace prelight::app
