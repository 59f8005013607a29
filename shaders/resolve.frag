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

vec4 mean_of_all(ivec2 pixel) {
    vec4 first = pixel_read(colour_buffer, pixel);
    bool differs = false;
    for (pixel_sample = 1; pixel_sample < samples; ++pixel_sample)
        differs = differs || pixel_read(colour_buffer, pixel) != first;
    vec4 mean = vec4(stored_encoded ? first.rgb : light_of(first.rgb), first.a);
    for (bool once = differs; once; once = false) { // a loop: a software device runs both sides of an `if`
        vec4 sum = vec4(0.0);
        EACH_SAMPLE {
            vec4 stored = pixel_read(colour_buffer, pixel);
            sum += vec4(light_of(stored.rgb), stored.a);
        }
        mean = sum / float(samples);
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
