#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SAMPLES
// Depth peeling, the nearest layer first: lets pass what lies behind the layer before, and not behind what is opaque. Of
// that the depth test leaves the nearest. Reversed depth: nearer is greater.
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_FIRST_LAYER) const bool first_layer = false; // there is none before
layout(set = SET_INPUTS, binding = INPUT_DEPTH) uniform PIXEL_IMAGE depth_before;
layout(set = SET_INPUTS, binding = INPUT_SAMPLE_DEPTH) uniform PIXEL_IMAGE opaque_depth;

void main() {
#ifdef SAMPLES
    pixel_sample = gl_SampleID;
#endif
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool again = !first_layer && gl_FragCoord.z >= pixel_read(depth_before, pixel).r;
    if (again || gl_FragCoord.z < pixel_read(opaque_depth, pixel).r)
        discard;
}
