#version 460
#extension GL_GOOGLE_include_directive : require
// Stage 1: the shading normal and roughness of the nearest surface; the only place that discards.
#include "shared/normal_encoding.h"
#include "shared/surface.glsl"

layout(constant_id = CONSTANT_NORMAL_ENCODING) const int normal_encoding = NORMAL_OCT24;
layout(constant_id = CONSTANT_NORMAL_SPACE) const bool view_space = false;

layout(location = 0) out vec4 out_normal;
#ifdef ROUGHNESS_TARGET  // for encodings that have no room for roughness
layout(location = ROUGHNESS_TARGET) out float out_roughness;
#endif
#ifdef DEPTH_TARGET  // view depth in metres, for depth=r32f
layout(location = DEPTH_TARGET) out float out_depth;
#endif

void main() {
    if (has(FEATURE_ALPHA_MASK) && base_colour().a < material.emissive.w)
        discard;
    vec3 n = shading_normal();
    if (view_space)
        n = mat3(frame.view_from_world) * n;
    float roughness = metallic_roughness().y;
    if (normal_encoding == NORMAL_OCT24)
        out_normal = vec4(oct24_encode(n), roughness_encode(roughness));
    else if (normal_encoding == NORMAL_OCT32)
        out_normal = vec4(oct32_encode(n), 0.0, 0.0);
    else
        out_normal = vec4(rgb10_encode(n), 0.0);
#ifdef ROUGHNESS_TARGET
    out_roughness = roughness;
#endif
#ifdef DEPTH_TARGET
    out_depth = dot(in_world, frame.forward.xyz);
#endif
}
