#version 460
#extension GL_GOOGLE_include_directive : require
// One direction a pixel into the target of a normal encoding, as depth_normal.frag stores it.
#include "shared/normal_encoding.h"

layout(constant_id = CONSTANT_NORMAL_ENCODING) const int normal_encoding = NORMAL_OCT24;
layout(set = SET_BENCH, binding = BENCH_DIRECTIONS) readonly buffer Directions { vec4 directions[]; };
layout(location = 0) out vec4 out_normal;

void main() {
    // w of a direction carries a roughness
    vec4 direction = directions[int(gl_FragCoord.y) * BENCH_WIDTH + int(gl_FragCoord.x)];
    out_normal = normal_encode(normal_encoding, direction.xyz, direction.w);
}
