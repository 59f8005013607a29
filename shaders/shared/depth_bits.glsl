// Depths as sets of 32 bits, so that a light between the near and the far surfaces of a tile is not in its list
// (Harada, "A 2.5D culling for Forward+", 2012). A bit is a 32nd of an octave of stored depth, the next octave
// begins with bit 0 again: no range need be known before.
#ifndef PRELIGHT_DEPTH_BITS_GLSL
#define PRELIGHT_DEPTH_BITS_GLSL

// `stored`: as read_depth() gives it.
uint depth_step(float stored) { return floatBitsToUint(stored) >> 18; }
uint depth_bit(float stored) { return 1u << (depth_step(stored) & 31u); }

// Of all depths between the two.
uint depth_bits(float a, float b) {
    uint low = depth_step(max(min(a, b), 0.0)), high = depth_step(max(max(a, b), 0.0));
    uint more = high - low;
    uint bits = more >= 31u ? 0xffffffffu : (2u << more) - 1u;
    uint by = low & 31u;
    return by == 0u ? bits : bits << by | bits >> (32u - by);
}
#endif
