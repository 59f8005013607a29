#version 460
#extension GL_GOOGLE_include_directive : require
// One direction a pixel into each normal format, rounded by the target itself.
#include "shared/normal_encoding.h"

layout(push_constant) uniform Push { vec4 size; } push; // x: width
layout(set = 0, binding = 0) readonly buffer Directions { vec4 directions[]; };
layout(location = 0) out vec4 out_oct24;
layout(location = 1) out vec2 out_oct32;
layout(location = 2) out vec4 out_rgb10;

void main() {
    // w of a direction carries a roughness
    vec4 direction = directions[int(gl_FragCoord.y) * int(push.size.x) + int(gl_FragCoord.x)];
    out_oct24 = vec4(oct24_encode(direction.xyz), roughness_encode(direction.w));
    out_oct32 = oct32_encode(direction.xyz);
    out_rgb10 = vec4(rgb10_encode(direction.xyz), 1.0);
}
