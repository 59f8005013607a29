#version 460
#extension GL_GOOGLE_include_directive : require
// The longest motion in each tile of MOTION_TILE squared pixels.
#include "shared/motion_blur.glsl"

layout(location = 0) out vec2 out_motion;

void main() {
    ivec2 low = ivec2(gl_FragCoord.xy) * MOTION_TILE, high = min(low + MOTION_TILE - 1, last_pixel());
    vec2 longest = vec2(0.0);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            vec2 motion = motion_at(ivec2(x, y));
            longest = dot(motion, motion) > dot(longest, longest) ? motion : longest;
        }
    out_motion = longest;
}
