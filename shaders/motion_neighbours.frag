#version 460
#extension GL_GOOGLE_include_directive : require
// The longest motion of a tile and the eight around it: from farther away nothing comes over the tile's pixels.
#include "shared/pixel_reads.glsl"

layout(set = SET_INPUTS, binding = INPUT_MOTION_TILES) uniform PIXEL_IMAGE tiles;
layout(location = 0) out vec2 out_motion;

void main() {
    ivec2 tile = ivec2(gl_FragCoord.xy);
    vec2 longest = vec2(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            vec2 motion = pixel_read(tiles, clamp(tile + ivec2(x, y), ivec2(0), last_pixel())).xy;
            longest = dot(motion, motion) > dot(longest, longest) ? motion : longest;
        }
    out_motion = longest;
}
