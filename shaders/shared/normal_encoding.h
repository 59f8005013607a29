// Normals in few bits. The same text is compiled as C++ and as GLSL. `encode` returns values that the
// target format rounds to its own steps; `decode` takes what the target gives back, 0 … 1.
#ifndef PRELIGHT_NORMAL_ENCODING_H
#define PRELIGHT_NORMAL_ENCODING_H
#include "shared/interop.h"
SHARED_BEGIN

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
    vec2 p = octahedral_encode(n);
    float x = floor(p.x * 2047.0f + 2047.5f);
    float y = floor(p.y * 2047.0f + 2047.5f);
    float x_high = floor(x / 16.0f);
    float y_high = floor(y / 256.0f);
    return vec3(x_high, (x - 16.0f * x_high) * 16.0f + y_high, y - 256.0f * y_high) / 255.0f;
}

SHARED_FUNCTION vec3 oct24_decode(vec3 stored) {
    vec3 b = floor(stored * 255.0f + 0.5f);
    float middle_high = floor(b.y / 16.0f);
    float x = b.x * 16.0f + middle_high;
    float y = (b.y - 16.0f * middle_high) * 256.0f + b.z;
    return octahedral_decode(vec2(x, y) / 2047.0f - vec2(1.0f, 1.0f));
}

// oct32: two 16-bit unsigned normalised channels, 65,534 steps so that the axes are exact.
SHARED_FUNCTION vec2 oct32_encode(vec3 n) {
    vec2 p = octahedral_encode(n);
    return (floor(p * 32767.0f + 0.5f) + 32767.0f) / 65535.0f;
}

SHARED_FUNCTION vec3 oct32_decode(vec2 stored) {
    return octahedral_decode(floor(stored * 65535.0f + 0.5f) / 32767.0f - vec2(1.0f, 1.0f));
}

// 10:10:10:2, the Round 2 sample's remapping (n + 1) / 2.
SHARED_FUNCTION vec3 rgb10_encode(vec3 n) { return n * 0.5f + 0.5f; }
SHARED_FUNCTION vec3 rgb10_decode(vec3 stored) { return normalize(stored * 2.0f - 1.0f); }

// Perceptual roughness in the 8-bit alpha of oct24: even steps of 0.95 % over what shading uses, 0.089
// to 1. A highlight's peak goes with roughness⁻⁴, so that even steps in roughness itself would put
// 8 % error on the smoothest surfaces.
SHARED_FUNCTION float roughness_encode(float roughness) {
    return 1.0f + log2(clamp(roughness, 0.089f, 1.0f)) * (1.0f / 3.4900509f);
}
SHARED_FUNCTION float roughness_decode(float stored) { return exp2((stored - 1.0f) * 3.4900509f); }

SHARED_END
#endif
