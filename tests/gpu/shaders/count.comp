#version 460
// target[i] = i + push.x
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { vec4 first; } push;
layout(set = 0, binding = 0) writeonly buffer Target { uint target[]; };
void main() { target[gl_GlobalInvocationID.x] = gl_GlobalInvocationID.x + uint(push.first.x); }
