#version 460
#extension GL_GOOGLE_include_directive : require
// A slot's depths as a depth image.
#include "shared/k_buffer.glsl"

layout(constant_id = CONSTANT_K_BUFFER_SLOT) const uint slot = 0u;

void main() { gl_FragDepth = uintBitsToFloat(k_buffer[first_slot() + slot]); }
