// Normals in few bits. The same text is compiled as C++ and as GLSL. `encode` returns values that the
// target format rounds to its own steps; `decode` takes what the target gives back, 0 … 1.
#ifndef PRELIGHT_NORMAL_ENCODING_H
#define PRELIGHT_NORMAL_ENCODING_H
#include "shared/bindings.h"
#include "shared/interop.h"
SHARED_BEGIN

// Two whole numbers, 0 … 4,095, in RGB of an 8-bit target.
SHARED_FUNCTION vec3 pack_12_12(vec2 p) {
    float x_high = floor(p.x / 16.0f);
    float y_high = floor(p.y / 256.0f);
    return vec3(x_high, (p.x - 16.0f * x_high) * 16.0f + y_high, p.y - 256.0f * y_high) / 255.0f;
}

SHARED_FUNCTION vec2 unpack_12_12(vec3 stored) {
    vec3 b = floor(stored * 255.0f + 0.5f);
    float middle_high = floor(b.y / 16.0f);
    return vec2(b.x * 16.0f + middle_high, (b.y - 16.0f * middle_high) * 256.0f + b.z);
}

// Octahedral map of the unit sphere to [−1, 1]² (Meyer and others 2010; Cigolle and others 2014).
SHARED_FUNCTION vec2 octahedral_encode(vec3 n) {
    float s = abs(n.x) + abs(n.y) + abs(n.z);
    vec2 p = vec2(n.x / s, n.y / s);
    if (n.z < 0.0f)
        p = vec2((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f),
                 (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f));
    return p;
}

SHARED_FUNCTION vec3 octahedral_decode(vec2 p) {
    vec3 n = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
    float t = max(-n.z, 0.0f);
    n.x += n.x >= 0.0f ? -t : t;
    n.y += n.y >= 0.0f ? -t : t;
    return normalize(n);
}

// oct24: 12 + 12 bits in RGB of an 8-bit target. Odd step count 4094, so that the axes are exact.
SHARED_FUNCTION vec3 oct24_encode(vec3 n) {
    return pack_12_12(floor(octahedral_encode(n) * 2047.0f + 2047.5f));
}

SHARED_FUNCTION vec3 oct24_decode(vec3 stored) {
    return octahedral_decode(unpack_12_12(stored) / 2047.0f - vec2(1.0f, 1.0f));
}

// oct32: two 16-bit unsigned normalised channels, 65,534 steps so that the axes are exact.
SHARED_FUNCTION vec2 oct32_encode(vec3 n) {
    vec2 p = octahedral_encode(n);
    return (floor(p * 32767.0f + 0.5f) + 32767.0f) / 65535.0f;
}

SHARED_FUNCTION vec3 oct32_decode(vec2 stored) {
    return octahedral_decode(floor(stored * 65535.0f + 0.5f) / 32767.0f - vec2(1.0f, 1.0f));
}

// oct16: two 8-bit channels, 254 steps so that the axes are exact.
SHARED_FUNCTION vec2 oct16_encode(vec3 n) {
    return (floor(octahedral_encode(n) * 127.0f + 0.5f) + 127.0f) / 255.0f;
}

SHARED_FUNCTION vec3 oct16_decode(vec2 stored) {
    return octahedral_decode(floor(stored * 255.0f + 0.5f) / 127.0f - vec2(1.0f, 1.0f));
}

// XYZ in 10:10:10:2 or 8:8:8, the Round 2 sample's remapping (n + 1) / 2. No code means 0.
SHARED_FUNCTION vec3 xyz_encode(vec3 n) { return n * 0.5f + 0.5f; }
SHARED_FUNCTION vec3 xyz_decode(vec3 stored) { return normalize(stored * 2.0f - 1.0f); }

// Spherical coordinates in 8:8:8 (Engel recommends them for world space): θ from the z axis in 12 bits,
// 4,094 steps so that the equator and both poles are exact; φ in 12 bits, 4,096 steps that go round,
// so that there is no seam and the other axes are exact. At a pole φ is 0 and says nothing.
SHARED_FUNCTION vec3 spherical_encode(vec3 n) {
    float across = sqrt(n.x * n.x + n.y * n.y);
    float theta = floor(atan(across, n.z) * (4094.0f / 3.14159265f) + 0.5f);
    float phi = across > 0.0f ? floor(atan(n.y, n.x) * (2048.0f / 3.14159265f) + 0.5f) : 0.0f;
    return pack_12_12(vec2(theta, phi < 0.0f ? phi + 4096.0f : phi));
}

SHARED_FUNCTION vec3 spherical_decode(vec3 stored) {
    vec2 p = unpack_12_12(stored);
    float theta = p.x * (3.14159265f / 4094.0f);
    float phi = (p.y > 2048.0f ? p.y - 4096.0f : p.y) * (3.14159265f / 2048.0f);
    return normalize(vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)));
}

// X and Y as 16-bit floats, Z from the length (Valient's layout). Where Z is near 0 a step of X or Y
// moves it by 1° and more: of the four pairs of halves around X and Y the one that comes back nearest
// is stored, which also leaves no rounding to the driver. Halves have room beyond 1: where Z is
// negative both are multiplied by 2¹⁵, which costs no bit; what would stay at 2 or below there, within
// 0.005° of −Z, is −Z.
SHARED_FUNCTION vec2 xy16_encode(vec3 n) {
    const uint step_of_half = 0x2000u; // in the bits of a 32-bit float
    uint x = floatBitsToUint(n.x) & ~(step_of_half - 1u);
    uint y = floatBitsToUint(n.y) & ~(step_of_half - 1u);
    vec2 nearest = vec2(0.0f, 0.0f);
    float least = 4.0f;
    for (uint i = 0u; i < 4u; ++i) {
        vec2 p = vec2(uintBitsToFloat(x + (i & 1u) * step_of_half), uintBitsToFloat(y + (i >> 1u) * step_of_half));
        float z = sqrt(max(1.0f - p.x * p.x - p.y * p.y, 0.0f));
        vec3 off = vec3(p.x - n.x, p.y - n.y, z - abs(n.z));
        if (dot(off, off) < least) {
            least = dot(off, off);
            nearest = p;
        }
    }
    if (n.z >= 0.0f)
        return nearest;
    return max(abs(nearest.x), abs(nearest.y)) < 1.0f / 16384.0f ? vec2(2.0f, 0.0f) : nearest * 32768.0f;
}

SHARED_FUNCTION vec3 xy16_decode(vec2 stored) {
    float largest = max(abs(stored.x), abs(stored.y));
    bool behind = largest > 1.5f;
    vec2 p = !behind ? stored : largest > 2.0f ? stored / 32768.0f : vec2(0.0f, 0.0f);
    float z = sqrt(max(1.0f - p.x * p.x - p.y * p.y, 0.0f));
    return normalize(vec3(p.x, p.y, behind ? -z : z));
}

// Perceptual roughness in the 8-bit alpha of the 24-bit encodings: even steps of 0.95 % over what shading uses, 0.089
// to 1. A highlight's peak goes with roughness⁻⁴, so that even steps in roughness itself would put
// 8 % error on the smoothest surfaces.
SHARED_FUNCTION float roughness_encode(float roughness) {
    return 1.0f + log2(clamp(roughness, 0.089f, 1.0f)) * (1.0f / 3.4900509f);
}
SHARED_FUNCTION float roughness_decode(float stored) { return exp2((stored - 1.0f) * 3.4900509f); }

// ---- All of them, by NORMAL_….

// True where alpha holds the roughness; the others need a target of its own for it.
SHARED_FUNCTION bool normal_holds_roughness(int encoding) {
    return encoding == NORMAL_OCT24 || encoding == NORMAL_RGB8 || encoding == NORMAL_SPHERICAL;
}

// What goes into the target, from a unit vector.
SHARED_FUNCTION vec4 normal_encode(int encoding, vec3 n, float roughness) {
    float alpha = normal_holds_roughness(encoding) ? roughness_encode(roughness) : 0.0f;
    if (encoding == NORMAL_OCT32)
        return vec4(oct32_encode(n), 0.0f, 0.0f);
    if (encoding == NORMAL_OCT16)
        return vec4(oct16_encode(n), 0.0f, 0.0f);
    if (encoding == NORMAL_XY16F)
        return vec4(xy16_encode(n), 0.0f, 0.0f);
    if (encoding == NORMAL_SPHERICAL)
        return vec4(spherical_encode(n), alpha);
    if (encoding == NORMAL_OCT24)
        return vec4(oct24_encode(n), alpha);
    return vec4(xyz_encode(n), alpha);
}

SHARED_FUNCTION vec3 normal_decode(int encoding, vec4 stored) {
    vec2 two = vec2(stored.x, stored.y);
    vec3 three = vec3(stored.x, stored.y, stored.z);
    return encoding == NORMAL_OCT32       ? oct32_decode(two)
           : encoding == NORMAL_OCT16     ? oct16_decode(two)
           : encoding == NORMAL_XY16F     ? xy16_decode(two)
           : encoding == NORMAL_SPHERICAL ? spherical_decode(three)
           : encoding == NORMAL_OCT24     ? oct24_decode(three)
                                          : xyz_decode(three);
}

SHARED_END
#endif
