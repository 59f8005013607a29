#version 460
#extension GL_GOOGLE_include_directive : require
// variants: ONE_TARGET|LIGHT_PAIR|COUNT_TARGET
// Takes the light away from the 8 × 8 blocks of pixels that had some in the frame before and have none now.
#ifdef COUNT_TARGET // one image, too
#define ONE_TARGET
#endif
#define STORAGE_TARGET
#include "shared/light_target.glsl"
#include "shared/light_lists.h"

layout(local_size_x = LIT_BLOCK, local_size_y = LIT_BLOCK) in;
layout(push_constant) uniform ListBlock { LightListConstants lists; };
layout(set = SET_INPUTS, binding = INPUT_STALE_BLOCKS, std430) readonly buffer StaleBlock { LitBlocks stale; uint stale_blocks[]; };

void main() {
    uint number = gl_WorkGroupID.y * LIT_ROW + gl_WorkGroupID.x;
    if (number >= stale.dispatch.w)
        return;
    uint block = stale_blocks[min(number, max(stale.dispatch.w, 1u) - 1u)];
    // What lies outside the picture is not stored.
    ivec2 pixel = ivec2(block % lists.blocks.x, block / lists.blocks.x) * LIT_BLOCK + ivec2(gl_LocalInvocationID.xy);
#ifdef LIGHT_PAIR
    write_pair(pixel, vec4(0.0), vec4(0.0));
#else
    write_first(pixel, vec4(0.0));
#ifndef ONE_TARGET
    write_second(pixel, vec4(0.0));
#endif
#endif
}
