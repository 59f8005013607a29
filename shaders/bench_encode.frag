#version 460
#extension GL_GOOGLE_include_directive : require
// One value a pixel into a target of stage 1, as depth_normal.frag stores it: a direction by a normal
// encoding, or a view depth.
#include "shared/linear_depth.h"
#include "shared/normal_encoding.h"

layout(constant_id = CONSTANT_NORMAL_ENCODING) const int normal_encoding = NORMAL_OCT24;
layout(constant_id = CONSTANT_DEPTH_SOURCE) const int depth_source = DEPTH_ATTACHMENT;
layout(set = SET_BENCH, binding = BENCH_VALUES) readonly buffer Values { vec4 values[]; };
layout(location = 0) out vec4 out_stored;

void main() {
    // A unit vector and, in w, a roughness; or a depth in metres in x.
    vec4 value = values[int(gl_FragCoord.y) * BENCH_WIDTH + int(gl_FragCoord.x)];
    if (depth_source == DEPTH_ATTACHMENT)
        out_stored = normal_encode(normal_encoding, value.xyz, value.w);
    else
        out_stored = linear_depth_encode(depth_source, value.x);
}
