#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
// What encode_normals.frag wrote, decoded: three vec4 a pixel, oct24 (w: roughness), oct32, 10:10:10.
#include "shared/normal_encoding.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) writeonly buffer Decoded { vec4 decoded[]; };
layout(set = 0, binding = 1) uniform texture2D oct24;
layout(set = 0, binding = 2) uniform texture2D oct32;
layout(set = 0, binding = 3) uniform texture2D rgb10;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    int first = 3 * (pixel.y * textureSize(oct24, 0).x + pixel.x);
    vec4 stored = texelFetch(oct24, pixel, 0);
    decoded[first] = vec4(oct24_decode(stored.rgb), roughness_decode(stored.a));
    decoded[first + 1] = vec4(oct32_decode(texelFetch(oct32, pixel, 0).rg), 0.0);
    decoded[first + 2] = vec4(rgb10_decode(texelFetch(rgb10, pixel, 0).rgb), 0.0);
}
