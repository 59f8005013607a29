#version 460
#extension GL_GOOGLE_include_directive : require
// Counts the pixels of a fixed-point light buffer that hold its largest value in some channel: their light may be more.
#include "shared/light_scale.h"
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_CLIPPING_FIRST) const uint first_channels = 7u;
layout(constant_id = CONSTANT_CLIPPING_SECOND) const uint second_channels = 7u;
layout(local_size_x = LIGHT_CLIP_GROUP, local_size_y = LIGHT_CLIP_GROUP) in;
layout(set = SET_INPUTS, binding = INPUT_DIFFUSE_LIGHT) uniform PIXEL_IMAGE first_sum;
layout(set = SET_INPUTS, binding = INPUT_SPECULAR_LIGHT) uniform PIXEL_IMAGE second_sum;
layout(set = SET_INPUTS, binding = INPUT_LIGHT_SCALE, std430) buffer ResultBlock { LightScaleResult result; };

bool is_full(vec4 texel, uint channels) {
    uvec4 bits = uvec4(greaterThanEqual(texel, vec4(1.0))) * uvec4(1u, 2u, 4u, 8u);
    return ((bits.x | bits.y | bits.z | bits.w) & channels) != 0u;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThan(pixel, last_pixel())))
        return;
    bool clipped = is_full(pixel_read(first_sum, pixel), first_channels);
    if (second_channels != 0u)
        clipped = clipped || is_full(pixel_read(second_sum, pixel), second_channels);
    if (clipped)
        atomicAdd(result.clipped, 1u);
}
