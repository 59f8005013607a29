#version 460
#extension GL_GOOGLE_include_directive : require
// variants: ONE_TARGET|COUNT_TARGET|DEFERRED_TARGET, SHADOWS, STENCIL_ROUGHNESS|SAMPLES
// never: COUNT_TARGET SHADOWS, DEFERRED_TARGET STENCIL_ROUGHNESS, SAMPLES COUNT_TARGET
// only: DEFERRED_TARGET with SAMPLES
// All lights of a frame, or of a round of them, on every pixel, summed in registers and written once.
#include "shared/light_loop.h"
#include "shared/light_sums.glsl"
#ifdef SAMPLES
#include "shared/edge_reads.glsl"
#endif

layout(early_fragment_tests) in;
layout(push_constant) uniform LoopBlock { LightLoop loop; };

void main() {
#ifdef SAMPLES
    ivec2 pixel = edge_pixel_of_fragment();
    if (pixel.x < 0)
        discard;
#else
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#endif
    LightSums sums = no_light();
#if defined(DEFERRED_TARGET) && defined(SAMPLES)
    first_round = loop.first == 0u;
#endif
    if (loop.ambient > 0u)
        add_ambient(sums);
    LitPixel p = read_pixel(pixel);
    uint contributing = 0u;
    for (uint i = loop.first; i < loop.end; ++i)
        contributing += add_light(sums, p, light_source(light_at(light_order[i]))) ? 1u : 0u;
    count_lights(pixel, loop.end - loop.first, contributing);
    write_sums(pixel, sums);
}
