#include <algorithm>
#include <scene/procedural/random.hpp>

namespace prelight {

glm::vec3 hue_colour(double hue, double saturation) {
    // Smith's HSV hexcone ("Color Gamut Transform Pairs", SIGGRAPH 1978): each channel is a
    // trapezoid over the hue circle, shifted by a third of a turn.
    const auto channel = [&](double shift) {
        double h = 6 * (hue - std::floor(hue)) + shift;
        h = h >= 6 ? h - 6 : h;
        const double trapezoid = std::clamp(std::abs(h - 3) - 1, 0.0, 1.0);
        return static_cast<float>(std::fma(saturation, trapezoid - 1, 1.0));
    };
    return {channel(0), channel(4), channel(2)};
}

} // namespace prelight
