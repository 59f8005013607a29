#version 460
#extension GL_GOOGLE_include_directive : require
// The mean of a pixel's samples. Scene-linear ones give scene-linear light, or with a tone curve the finished picture:
// each sample is tone mapped before the mean, or one bright light would outweigh all else in its pixel. Finished ones
// are decoded first, for what is averaged is light. Samples that are all alike stay as they are.
// Where blended surfaces stand in half of the samples, each pair of samples is mixed first, as light. Or one sample by
// itself, for views.
#define SAMPLES
#include "shared/display.glsl"
#include "shared/half_samples.h"
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_STORED_ENCODED) const bool stored_encoded = false; // sRGB codes, read as they are
layout(constant_id = CONSTANT_RESOLVED) const int resolved = RESOLVED_ALL;
layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform PIXEL_IMAGE colour_buffer;
layout(location = 0) out vec4 out_colour;

vec3 light_of(vec3 stored) {
    if (stored_encoded)
        return srgb_decode(stored);
    return tonemap_curve == TONEMAP_LINEAR ? stored : clamp(tone_mapped(stored), 0.0, 1.0);
}

vec4 sample_at(ivec2 pixel, int i) {
    pixel_sample = i;
    return pixel_read(colour_buffer, pixel);
}

vec4 shown(vec4 stored) { return vec4(light_of(stored.rgb), stored.a); }

// Of an opaque sample and the other one of its half of the pixel: what the blended surface makes of both, or where there
// is none, their mean.
vec4 half_of(ivec2 pixel, int opaque) {
    vec4 behind = sample_at(pixel, opaque), over = sample_at(pixel, HALF_SAMPLES_OTHER(opaque));
    float alpha = -over.a;
    vec4 mixed = vec4(mix(behind.rgb, over.rgb, alpha), alpha + behind.a * (1.0 - alpha));
    return 0.5 * (shown(alpha > 0.0 ? mixed : behind) + shown(alpha > 0.0 ? mixed : over));
}

vec4 mean_of_halves(ivec2 pixel) {
    if (resolved == RESOLVED_OPAQUE)
        return 0.5 * (shown(sample_at(pixel, 0)) + shown(sample_at(pixel, 3)));
    return 0.5 * (half_of(pixel, 0) + half_of(pixel, 3));
}

// Codes of samples that differ by two at most may be averaged as they are, which is 0.03 codes off at the darkest. So
// it goes wherever triangles of one surface meet.
const float most_difference = 2.5 / 255.0;

vec4 mean_of_all(ivec2 pixel) {
    // Named one by one: a software device keeps arrays in memory.
    vec4 a = sample_at(pixel, 0), b = samples > 1 ? sample_at(pixel, 1) : a;
    vec4 c = samples > 2 ? sample_at(pixel, 2) : a, d = samples > 3 ? sample_at(pixel, 3) : b;
    vec4 apart = max(max(abs(b - a), abs(c - a)), abs(d - a));
    float most_apart = max(max(apart.r, apart.g), max(apart.b, apart.a));
    vec4 mean = vec4(stored_encoded ? a.rgb : light_of(a.rgb), a.a);
    if (stored_encoded)
        mean = most_apart > 0.0 ? 0.25 * (a + b + c + d) : a;
    if (most_apart > (stored_encoded ? most_difference : 0.0)) {
        mean = 0.25 * (shown(a) + shown(b) + shown(c) + shown(d));
        mean.rgb = stored_encoded ? srgb_encode(mean.rgb) : mean.rgb;
    }
    return mean;
}

vec4 only(ivec2 pixel, int i) {
    vec4 stored = sample_at(pixel, i);
    return stored_encoded ? stored : shown(stored);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 mean = resolved == RESOLVED_ALL      ? mean_of_all(pixel)
                : resolved >= RESOLVED_SAMPLE ? only(pixel, resolved - RESOLVED_SAMPLE)
                                              : mean_of_halves(pixel);
    bool encodes = !stored_encoded && tonemap_curve != TONEMAP_LINEAR && !target_encodes;
    out_colour = vec4(encodes ? srgb_encode(mean.rgb) : mean.rgb, mean.a);
}
