#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
// What bench_encode.frag stored, decoded as the light pass does.
#include "shared/normal_encoding.h"

layout(constant_id = CONSTANT_NORMAL_ENCODING) const int normal_encoding = NORMAL_OCT24;
layout(set = SET_BENCH, binding = BENCH_STORED) uniform texture2D normals;
layout(location = 0) out vec4 out_decoded; // w: roughness, where the encoding holds it

void main() {
    vec4 stored = texelFetch(normals, ivec2(gl_FragCoord.xy), 0);
    float roughness = normal_holds_roughness(normal_encoding) ? roughness_decode(stored.a) : 0.0;
    out_decoded = vec4(normal_decode(normal_encoding, stored), roughness);
}
