#version 460
// target[i] = 2 · source[last − i]: each invocation reads what another one wrote.
layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Source { uint source[]; };
layout(set = 0, binding = 1) writeonly buffer Target { uint target[]; };
void main() {
    uint last = gl_NumWorkGroups.x * 64u - 1u;
    target[gl_GlobalInvocationID.x] = 2u * source[last - gl_GlobalInvocationID.x];
}
