#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <prelight/image.hpp>

namespace prelight {
namespace {

// Khronos PBR Neutral tone mapper, specification of 2024 (KhronosGroup/ToneMapping, PBR_Neutral),
// names as there: F90 is the reflection that a base colour carries on top, Ks the value where
// compression starts, Kd the speed of desaturation.
glm::vec3 pbr_neutral(glm::vec3 colour) {
    constexpr float f90 = 0.04f, ks = 0.8f - f90, kd = 0.15f;
    const float x = std::min({colour.r, colour.g, colour.b});
    const float f = x <= 2 * f90 ? x - x * x / (4 * f90) : f90;
    colour -= f;
    const float p = std::max({colour.r, colour.g, colour.b});
    if (p <= ks)
        return colour;
    const float pn = 1 - (1 - ks) * (1 - ks) / (p + 1 - 2 * ks);
    const float g = 1 / (kd * (p - pn) + 1);
    return colour * (pn / p * g) + pn * (1 - g);
}

// K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2015: a rational fit, per channel.
glm::vec3 aces(glm::vec3 x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); }

} // namespace

glm::vec3 display_light(glm::vec3 colour, Tonemap curve) {
    // Both curves approach 1 long before this; it keeps infinities out of their quotients.
    constexpr float limit = 65504;
    for (int channel = 0; channel < 3; ++channel)
        colour[channel] = colour[channel] > 0 ? std::min(colour[channel], limit) : 0.0f;
    if (curve == Tonemap::pbr_neutral)
        colour = pbr_neutral(colour);
    else if (curve == Tonemap::aces)
        colour = aces(colour);
    return glm::clamp(colour, 0.0f, 1.0f);
}

Image tonemap(const Image& linear, Tonemap curve) {
    Image display(linear.width, linear.height);
    for (size_t i = 0; i < linear.pixels.size(); ++i) {
        const glm::vec3 light = display_light(linear.pixels[i], curve);
        for (int channel = 0; channel < 3; ++channel)
            display.pixels[i][channel] = srgb_encode(light[channel]);
    }
    return display;
}

} // namespace prelight
