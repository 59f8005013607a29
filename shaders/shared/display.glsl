// Scene-linear light → display values.
#ifndef PRELIGHT_DISPLAY_GLSL
#define PRELIGHT_DISPLAY_GLSL
#include "shared/bindings.h"

layout(constant_id = CONSTANT_TONEMAP) const int tonemap_curve = TONEMAP_LINEAR;

layout(constant_id = CONSTANT_TARGET_ENCODES) const bool target_encodes = false; // an sRGB format

// 1.055 x^(1/2.4) − 0.055 above 0.0031308. With t the fourth root, x^(1/2.4) is t^(5/3), which a polynomial
// over [0.2365, 1] (interpolation at Chebyshev nodes) meets within 0.0025/255.
vec3 srgb_encode(vec3 linear) {
    linear = clamp(linear, 0.0, 1.0);
    vec3 t = sqrt(sqrt(linear));
    vec3 power = -0.00628408 + t * (0.15637346 + t * (1.17934976 + t * (-0.52848877 + t * (0.25853293 + t * -0.0594872))));
    return mix(1.055 * power - 0.055, linear * 12.92, lessThanEqual(linear, vec3(0.0031308)));
}

// ((x + 0.055) / 1.055)^2.4 above 0.04045, by a polynomial that is within 0.004/255 of the code.
vec3 srgb_decode(vec3 code) {
    vec3 power = 0.00087161 + code * (0.03450124 + code * (0.49812459 + code * (0.77189283 + code * (-0.54117675 + code * (0.32343494 + code * -0.08767987)))));
    return mix(power, code / 12.92, lessThanEqual(code, vec3(0.04045)));
}

// Khronos PBR Neutral tone mapper, by its specification.
vec3 tonemap_pbr_neutral(vec3 colour) {
    const float start_compression = 0.8 - 0.04;
    const float desaturation = 0.15;
    float x = min(colour.r, min(colour.g, colour.b));
    float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
    colour -= offset;
    float peak = max(colour.r, max(colour.g, colour.b));
    if (peak < start_compression)
        return colour;
    const float d = 1.0 - start_compression;
    float new_peak = 1.0 - d * d / (peak + d - start_compression);
    colour *= new_peak / peak;
    float g = 1.0 - 1.0 / (desaturation * (peak - new_peak) + 1.0);
    return mix(colour, vec3(new_peak), g);
}

// ACES filmic curve, Narkowicz 2015.
vec3 tonemap_aces(vec3 x) { return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }

// Not yet encoded.
vec3 tone_mapped(vec3 colour) {
    if (tonemap_curve == TONEMAP_PBR_NEUTRAL)
        return tonemap_pbr_neutral(colour);
    return tonemap_curve == TONEMAP_ACES ? tonemap_aces(colour) : colour;
}

// What a pass stores of scene-linear light.
vec4 stored_colour(vec3 colour) {
    if (tonemap_curve == TONEMAP_LINEAR)
        return vec4(colour, 1.0);
    colour = tone_mapped(colour);
    return vec4(target_encodes ? colour : srgb_encode(colour), 1.0);
}
#endif
