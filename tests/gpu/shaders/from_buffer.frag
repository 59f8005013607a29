#version 460
// A picture out of a buffer, row by row.
layout(push_constant) uniform Push { vec4 size; } push; // x: width
layout(set = 0, binding = 0) readonly buffer Source { vec4 colours[]; };
layout(location = 0) out vec4 result;
void main() { result = colours[int(gl_FragCoord.y) * int(push.size.x) + int(gl_FragCoord.x)]; }
