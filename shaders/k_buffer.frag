#version 460
#extension GL_GOOGLE_include_directive : require
// A k-buffer: sorts the depths of blended surfaces into their sample's slots, in whatever order they come. Each slot
// keeps the nearest of what reaches it and hands on the rest, and atomicMax does both at once. A depth that is there
// already ends at its slot: all surfaces of one depth are one layer.
#define K_BUFFER_ACCESS
#include "shared/k_buffer.glsl"

layout(early_fragment_tests) in;

void main() {
    uint key = floatBitsToUint(gl_FragCoord.z);
    uint first = first_slot();
    for (uint i = 0u; i < slots_of_sample && key != 0u; ++i) {
        uint before = atomicMax(k_buffer[first + i], key);
        key = before == key ? 0u : min(before, key);
    }
}
