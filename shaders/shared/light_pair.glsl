// Both halves of a light buffer's pair in one RGBA32UI texel, as half floats: a software device pays for each store
// and each fetch, and converts half floats one by one where the shader does it eight at a time.
#ifndef PRELIGHT_LIGHT_PAIR_GLSL
#define PRELIGHT_LIGHT_PAIR_GLSL

// The nearest half floats of values from 0 to 65,504. packHalf2x16 cuts off on some drivers, and lavapipe takes
// longer for it than for all of this. Below 2⁻¹⁴ a half float counts steps of 2⁻²⁴.
uvec4 half_bits(vec4 value) {
    uvec4 normal = (floatBitsToUint(value) + 0xfffu - 0x38000000u) >> 13;
    uvec4 small = uvec4(value * 16777216.0 + 0.5);
    return mix(normal, small, lessThan(value, vec4(6.103515625e-5)));
}
uvec4 light_pair(vec4 first, vec4 second) {
    uvec4 a = half_bits(first), b = half_bits(second);
    return uvec4(a.xz | a.yw << 16, b.xz | b.yw << 16);
}

vec4 half_floats(uvec2 bits) { return vec4(unpackHalf2x16(bits.x), unpackHalf2x16(bits.y)); }
#endif
