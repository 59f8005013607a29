#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SAMPLES
// Depth peeling in reverse order: lets pass what lies nearer than the layer before. Of that the depth test leaves the
// farthest. Reversed depth: nearer is greater.
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_FIRST_LAYER) const bool first_layer = false; // what is before is opaque, and may be touched
layout(set = SET_INPUTS, binding = INPUT_DEPTH) uniform PIXEL_IMAGE depth_before;

void main() {
#ifdef SAMPLES
    pixel_sample = gl_SampleID;
#endif
    float before = pixel_read(depth_before, ivec2(gl_FragCoord.xy)).r;
    if (first_layer ? gl_FragCoord.z < before : gl_FragCoord.z <= before)
        discard;
}
