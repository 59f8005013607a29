#version 460
#extension GL_GOOGLE_include_directive : require
// One full-screen triangle a light, at the far end: depth test LESS keeps it off the background.
#include "shared/frame.glsl"
layout(location = 0) flat out uint out_light;

void main() {
    out_light = light_order[gl_InstanceIndex];
    vec2 corner = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
