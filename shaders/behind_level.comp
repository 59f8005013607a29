#version 460
#extension GL_GOOGLE_include_directive : require
// One level of what lies behind transmissive surfaces (docs/transmission.md): level 0 is the opaque picture, each further
// one halves the one before with the weights 1 3 3 1 along either axis.
#include "shared/behind.h"
#include "shared/light_pair.glsl"
#include "shared/pixel_reads.glsl"

layout(local_size_x = BEHIND_GROUP, local_size_y = BEHIND_GROUP) in;
layout(constant_id = CONSTANT_BEHIND_COPIES) const bool copies = false; // level 0
layout(push_constant) uniform LevelBlock { int level; };
layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform ONE_SAMPLE_IMAGE before; // the picture; or the same image
layout(set = SET_INPUTS, binding = INPUT_BEHIND_TARGET, rgba16f) writeonly uniform image2D target;

void main() {
    ivec2 size = ivec2(raster.size.xy), texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, behind_size(size, level))))
        return;
    ivec2 place = behind_corner(size, level) + texel;
    if (copies) {
        imageStore(target, place, min(one_sample_read(before, texel), vec4(65504.0))); // it may be wider
        return;
    }
    ivec2 corner = behind_corner(size, level - 1), last = behind_size(size, level - 1) - 1;
    vec3 sum = vec3(0.0);
    for (int y = -1; y <= 2; ++y)
        for (int x = -1; x <= 2; ++x) {
            float weight = (x == 0 || x == 1 ? 3.0 : 1.0) * (y == 0 || y == 1 ? 3.0 : 1.0) / 64.0;
            sum += weight * one_sample_read(before, corner + clamp(2 * texel + ivec2(x, y), ivec2(0), last)).rgb;
        }
    // To the nearest half float: a driver may cut off, level after level.
    uvec4 bits = half_bits(vec4(max(sum, vec3(0.0)), 1.0));
    imageStore(target, place, half_floats(uvec2(bits.x | bits.y << 16, bits.z | bits.w << 16)));
}
