#version 460
#extension GL_GOOGLE_include_directive : require
// variants: OWN_MATERIAL, ROUGHNESS_TARGET|STENCIL_ROUGHNESS|NO_NORMAL_TARGET, DEPTH_TARGET, DECALS|NO_TEXTURES|LAYER_DECALS, SAMPLES, SURFACE_IDS, LAYER
// only: SAMPLES with DECALS, LAYER with SURFACE_IDS, LAYER_DECALS with LAYER
// never: SURFACE_IDS DECALS, SURFACE_IDS DEPTH_TARGET, SURFACE_IDS ROUGHNESS_TARGET, SURFACE_IDS STENCIL_ROUGHNESS, SURFACE_IDS NO_NORMAL_TARGET
// never: DECALS DEPTH_TARGET, OWN_MATERIAL NO_TEXTURES, NO_NORMAL_TARGET NO_TEXTURES
// only: NO_NORMAL_TARGET with DEPTH_TARGET
// materials: all with OWN_MATERIAL
#ifdef STENCIL_ROUGHNESS
#extension GL_ARB_shader_stencil_export : require
#endif
// Stage 1: the shading normal and roughness of the nearest surface; the only place that discards.
// Compiled with NO_NORMAL_TARGET it is the first of two passes: depth alone.
#if !defined(DEPTH_TARGET) && !defined(OWN_MATERIAL) && !defined(LAYER_DECALS)
#define NO_WORLD
#endif
#if defined(NO_NORMAL_TARGET) && !defined(OWN_MATERIAL)
#define NO_NORMAL
#endif
#include "shared/half_samples.glsl"
#include "shared/linear_depth.h"
#include "shared/material_interface.glsl"
#include "shared/normal_encoding.h"
#include "shared/specular_antialiasing.glsl"
#ifdef LAYER
#include "shared/layer.h"
layout(push_constant) uniform LayerBlock { LayerConstants layer; };
#endif

layout(constant_id = CONSTANT_NORMAL_ENCODING) const int normal_encoding = NORMAL_OCT24;
layout(constant_id = CONSTANT_NORMAL_SPACE) const bool view_space = false;
layout(constant_id = CONSTANT_DEPTH_SOURCE) const int depth_source = DEPTH_ATTACHMENT;

#ifndef NO_NORMAL_TARGET
layout(location = 0) out vec4 out_normal;
#endif
#ifdef SURFACE_IDS  // of inferred lighting: the draw's number and the smooth group
layout(location = 6) flat in uvec2 in_surface;
layout(location = 1) out uvec2 out_surface;
#endif
#ifdef ROUGHNESS_TARGET  // for encodings that have no room for roughness
layout(location = 1) out float out_roughness;
#endif
#ifdef DEPTH_TARGET  // for depth= anything but the attachment
#if defined(NO_NORMAL_TARGET)
layout(location = 0) out vec4 out_depth;
#elif defined(ROUGHNESS_TARGET)
layout(location = 2) out vec4 out_depth;
#else
layout(location = 1) out vec4 out_depth;
#endif
#endif

void main() {
    Point p = point();
    Surface s = surface_under_decals(p);
#ifndef NO_NORMAL_TARGET
    float roughness = antialiased_roughness(p, s);
#endif
    if (is_left_out(s))
        discard;
#ifdef LAYER
    if ((uint(gl_FragCoord.x) & 1u) + 2u * (uint(gl_FragCoord.y) & 1u) != layer.slot)
        discard;
#endif
#ifndef NO_NORMAL_TARGET
    vec3 n = s.normal;
    if (view_space)
        n = mat3(frame.view_from_world) * n;
    out_normal = normal_encode(normal_encoding, n, roughness);
#endif
#ifdef SURFACE_IDS
    out_surface = in_surface;
#endif
#ifdef ROUGHNESS_TARGET
    out_roughness = roughness;
#endif
#ifdef STENCIL_ROUGHNESS
    gl_FragStencilRefARB = int(roughness_encode(roughness) * 255.0 + 0.5);
#endif
#ifdef DEPTH_TARGET
    out_depth = linear_depth_encode(depth_source, dot(in_world, frame.forward.xyz));
#endif
}
