#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SAMPLES
// Depth into another image, that draws may go on in without the first one knowing.
#include "shared/pixel_reads.glsl"

layout(set = SET_INPUTS, binding = INPUT_DEPTH) uniform PIXEL_IMAGE depth_buffer;

void main() {
#ifdef SAMPLES
    pixel_sample = gl_SampleID;
#endif
    gl_FragDepth = pixel_read(depth_buffer, ivec2(gl_FragCoord.xy)).r;
}
