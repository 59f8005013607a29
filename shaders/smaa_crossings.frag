#version 460
#extension GL_GOOGLE_include_directive : require
// The edges of a pixel and what continues them, in one texel, so that searches along lines fetch one a pixel.
#include "shared/pixel_reads.glsl"
#include "shared/smaa.h"

layout(set = SET_INPUTS, binding = INPUT_SMAA_EDGES) uniform PIXEL_IMAGE edge_buffer;
layout(location = 0) out float out_edges;

int edges_at(ivec2 at) { return int(pixel_read(edge_buffer, max(at, ivec2(0))).r * 255.0 + 0.5); }

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int edges = edges_at(at);
    // At the borders, a pixel's own edge that nobody has.
    if ((edges_at(at - ivec2(0, 1)) & SMAA_LEFT) != 0 && at.y > 0)
        edges += SMAA_LEFT_OF_UPPER;
    if ((edges_at(at - ivec2(1, 0)) & SMAA_ABOVE) != 0 && at.x > 0)
        edges += SMAA_ABOVE_BEFORE;
    out_edges = float(edges) / 255.0;
}
