#version 460
#extension GL_GOOGLE_include_directive : require
// variants: ONE_TARGET
// Ambient light as a light of its own: a full-screen quad that adds to the diffuse sum.
#include "shared/light_sums.glsl"

layout(location = 0) flat in uint in_light;

void main() {
    LightSums sums = no_light();
    add_ambient(sums);
    write_sums(ivec2(gl_FragCoord.xy), sums);
}
