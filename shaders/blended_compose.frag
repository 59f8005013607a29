#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SAMPLES
// Weighted blended transparency, its second step: the mean colour of the layers of a pixel (of each of its samples), over
// what is behind. McGuire and Bavoil, "Weighted Blended Order-Independent Transparency", JCGT 2(2), 2013, equation (6),
// whose last term and sum are the blending.
#include "shared/pixel_reads.glsl"

layout(set = SET_INPUTS, binding = INPUT_BLENDED_SUM) uniform PIXEL_IMAGE sums;       // rgb: colours; a: what is left of what is behind
layout(set = SET_INPUTS, binding = INPUT_BLENDED_WEIGHT) uniform PIXEL_IMAGE weights; // r: their weights
layout(location = 0) out vec4 out_colour;

const float largest = 65504.0;  // half float: sums of more layers than they are made for end at infinity
const float smallest = 6e-8;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef SAMPLES
    pixel_sample = gl_SampleID;
#endif
    vec4 sum = min(pixel_read(sums, pixel), vec4(largest));
    float weight = clamp(pixel_read(weights, pixel).r, smallest, largest);
    out_colour = vec4(sum.rgb / weight, 1.0 - sum.a);
}
