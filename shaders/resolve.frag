#version 460
#extension GL_GOOGLE_include_directive : require
// The mean of a pixel's samples. Scene-linear ones give scene-linear light, or with a tone curve the finished picture:
// each sample is tone mapped before the mean, or one bright light would outweigh all else in its pixel. Finished ones
// are decoded first, for what is averaged is light. Samples that are all alike stay as they are.
#define SAMPLES
#include "shared/display.glsl"
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_STORED_ENCODED) const bool stored_encoded = false; // sRGB codes, read as they are
layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform PIXEL_IMAGE colour_buffer;
layout(location = 0) out vec4 out_colour;

vec3 light_of(vec3 stored) {
    if (stored_encoded)
        return srgb_decode(stored);
    return tonemap_curve == TONEMAP_LINEAR ? stored : clamp(tone_mapped(stored), 0.0, 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
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
    bool encodes = !stored_encoded && tonemap_curve != TONEMAP_LINEAR && !target_encodes;
    out_colour = vec4(encodes ? srgb_encode(mean.rgb) : mean.rgb, mean.a);
}
