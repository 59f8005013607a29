#version 460
#extension GL_GOOGLE_include_directive : require
// A slot's depths as a depth image.
#include "shared/layer_slots.glsl"

layout(constant_id = CONSTANT_LAYER_SLOT) const uint slot = 0u;

void main() { gl_FragDepth = uintBitsToFloat(layer_slots[first_slot() + slot]); }
