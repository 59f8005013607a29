#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
// What bench_encode.frag stored, decoded as the light pass does.
#include "shared/linear_depth.h"
#include "shared/normal_encoding.h"

layout(constant_id = CONSTANT_NORMAL_ENCODING) const int normal_encoding = NORMAL_OCT24;
layout(constant_id = CONSTANT_DEPTH_SOURCE) const int depth_source = DEPTH_ATTACHMENT;
layout(set = SET_BENCH, binding = BENCH_STORED) uniform texture2D target;
layout(location = 0) out vec4 out_value; // as the values were; w: 0 where the encoding has no roughness

void main() {
    vec4 stored = texelFetch(target, ivec2(gl_FragCoord.xy), 0);
    float roughness = normal_holds_roughness(normal_encoding) ? roughness_decode(stored.a) : 0.0;
    if (depth_source == DEPTH_ATTACHMENT)
        out_value = vec4(normal_decode(normal_encoding, stored), roughness);
    else
        out_value = vec4(linear_depth_decode(depth_source, stored), 0.0, 0.0, 0.0);
}
