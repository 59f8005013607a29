#version 460
#extension GL_GOOGLE_include_directive : require
// variants: OWN_MATERIAL, OCCLUSION, DECALS, SAMPLES
// only: SAMPLES with DECALS
// materials: all with OWN_MATERIAL
// Deferred shading's geometry pass: all that lights need of the nearest surface, and the light
// that no light source sends. The only place that discards. A material's surface() fills it, and its shade() is asked
// for that light; light sources meet metallic-roughness only, which is all that the G-buffer knows.
#include "shared/base_light.glsl"
#include "shared/gbuffer_layout.glsl"
#include "shared/half_samples.glsl"
#include "shared/pixel_reads.glsl"
#include "shared/specular_antialiasing.glsl"

layout(constant_id = CONSTANT_NORMAL_SPACE) const bool view_space = false;

#ifndef SURFACE_GLOSS // a material's factor on what it reflects
#define SURFACE_GLOSS(p) 1.0
#endif

layout(location = 5) in vec3 in_previous; // where in_world was at the previous state

layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_normal;
layout(location = 2) out vec4 out_motion;
layout(location = 3) out vec4 out_albedo;
#ifdef OCCLUSION  // ambient light waits for its occlusion: ambient_light.frag
layout(location = 4) out vec4 out_ambient;
layout(location = 5) out vec4 out_mirrored; // alpha: the roughness that it was mirrored with
#endif

// Pixels from the picture's middle. A point behind the camera has no place there: it is very far out.
vec2 on_picture(mat4 clip_from_world, vec3 world) {
    vec4 clip = clip_from_world * vec4(world, 1.0);
    return clip.xy / max(clip.w, 1e-6) * 0.5 * raster.size.xy;
}

// Pixels since the previous state, right and down positive. Both places are interpolated alike, so that
// what stands still has exactly none.
vec2 motion() {
    return on_picture(frame.clip_from_world, in_world) - on_picture(frame.previous_clip_from_world, in_previous);
}

void main() {
    Point p = point();
    Surface s = surface_under_decals(p);
    float roughness = antialiased_roughness(p, s);
    if (is_left_out(s))
        discard;
    vec3 n = s.normal;
    if (view_space)
        n = mat3(frame.view_from_world) * n;
    GBufferTexels texels = gbuffer_encode(n, roughness, motion(), s.base, s.metallic, SURFACE_GLOSS(p), s.occlusion, has(FEATURE_UNLIT));
    out_normal = texels.normal;
    out_motion = texels.motion;
    out_albedo = texels.albedo;
#ifdef OCCLUSION
    BaseLight base = base_light_in_parts(p, s);
    vec3 own = base.own;
    out_ambient = vec4(clamp(base.ambient, 0.0, 65504.0), 1.0);
    out_mirrored = vec4(clamp(base.mirrored, 0.0, 65504.0), s.roughness);
#else
    vec3 own = base_light(p, s);
#endif
    vec3 stored = min(own / frame.light_buffer.x, vec3(frame.ambient.w));
    out_light = vec4(stored, luminance(stored) / INTENSITY_RANGE);
}
