#version 460
#extension GL_GOOGLE_include_directive : require
// variants: ONE_TARGET|COUNT_TARGET|DEFERRED_TARGET, SHADOWS, STENCIL_ROUGHNESS
// never: COUNT_TARGET SHADOWS, DEFERRED_TARGET STENCIL_ROUGHNESS
// One light on the pixels of its volume, rectangle or the whole screen; blended ONE/ONE.
#include "shared/light_sums.glsl"

layout(early_fragment_tests) in;
layout(location = 0) flat in uint in_light;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    LightSums sums = no_light();
    bool contributes = add_light(sums, read_pixel(pixel), light_source(light_at(in_light)));
    count_lights(pixel, 1u, contributes ? 1u : 0u);
    write_sums(pixel, sums);
}
