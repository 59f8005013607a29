// View depth in metres in a colour target. The same text is compiled as C++ and as GLSL.
#ifndef PRELIGHT_LINEAR_DEPTH_H
#define PRELIGHT_LINEAR_DEPTH_H
#include "shared/bindings.h"
#include "shared/interop.h"
SHARED_BEGIN

// RGBA8: the four bytes of the 32-bit float, the highest in R, so that nothing is lost against R32F.
// No surface is 0 in all.
SHARED_FUNCTION vec4 depth_pack(float z) {
    uint bits = floatBitsToUint(z);
    return vec4(float(bits >> 24u), float(bits >> 16u & 255u), float(bits >> 8u & 255u), float(bits & 255u)) / 255.0f;
}

SHARED_FUNCTION float depth_unpack(vec4 stored) {
    uvec4 b = uvec4(stored * 255.0f + 0.5f);
    return uintBitsToFloat(b.x << 24u | b.y << 16u | b.z << 8u | b.w);
}

// `source`: DEPTH_R32F, DEPTH_R16F or DEPTH_RGBA8. A half float keeps 11 bits of depth, up to 65,504 m.
SHARED_FUNCTION vec4 linear_depth_encode(int source, float z) {
    if (source == DEPTH_RGBA8)
        return depth_pack(z);
    return vec4(source == DEPTH_R16F ? clamp(z, 6.2e-5f, 65504.0f) : z, 0.0f, 0.0f, 0.0f);
}

SHARED_FUNCTION float linear_depth_decode(int source, vec4 stored) {
    return source == DEPTH_RGBA8 ? depth_unpack(stored) : stored.x;
}

SHARED_END
#endif
