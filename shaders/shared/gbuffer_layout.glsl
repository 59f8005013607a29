// What the targets of a G-buffer hold of a surface; one function writes them, the others read.
//            RT1                      RT2                                  RT3
// wide       oct24 normal, roughness  motion XY, dullness where there is   base colour, metallic
// killzone2  view normal X, Y         motion XY, spec power, intensity     diffuse albedo, sun occlusion
// Sun occlusion: what comes past casters of the first directional light that has shadow maps (sun_occlusion.frag); where none
// has, the material's own occlusion.
// RT0 accumulates light: RGB, and in alpha its luminance in steps that are INTENSITY_RANGE times wider.
#ifndef PRELIGHT_GBUFFER_LAYOUT_GLSL
#define PRELIGHT_GBUFFER_LAYOUT_GLSL
#include "shared/bindings.h"
#include "shared/motion_encoding.h"
#include "shared/normal_encoding.h"
#include "shared/reflectance.glsl"

layout(constant_id = CONSTANT_GBUFFER) const int gbuffer_layout = GBUFFER_NONE;

#define INTENSITY_RANGE 8.0

struct GBufferTexels {
    vec4 normal, motion, albedo;  // RT1, RT2, RT3
};

// Square roots spread 8 bits more evenly over what an eye sees, and 0.04 is a step of theirs.
vec3 root_encode(vec3 v) { return sqrt(max(v, vec3(0.0))); }
vec3 root_decode(vec3 v) { return v * v; }

// `n`: world space for wide, view space for killzone2. `motion`: pixels. `gloss`: factor on F0.
GBufferTexels gbuffer_encode(vec3 n, float roughness, vec2 motion, vec3 base, float metallic, float gloss, float occlusion,
                             bool unlit) {
    GBufferTexels texels;
    if (gbuffer_layout == GBUFFER_WIDE) {
        texels.normal = vec4(oct24_encode(n), roughness_encode(roughness));
        texels.motion = vec4(motion_clamp(motion), 1.0 - gloss, 0.0); // a target without it reads as 0
        // Negative: takes no light.
        texels.albedo = vec4(base, unlit ? -1.0 : metallic);
    } else {
        Reflectance r = reflectance(base, metallic);
        float grey = gloss * dot(r.f0, vec3(0.2126, 0.7152, 0.0722));
        // Specular power as the logarithm that roughness_encode() takes of it. Intensity 0: takes no light.
        float intensity = unlit ? 0.0 : max(sqrt(grey), 1.0 / 255.0);
        texels.normal = vec4(xy16_encode(n), 0.0, 0.0);
        texels.motion = vec4(motion8_encode(motion), roughness_encode(roughness), intensity);
        texels.albedo = vec4(root_encode(unlit ? base : r.diffuse), occlusion);
    }
    return texels;
}

// From RT2, in pixels.
vec2 stored_motion(vec4 motion) {
    return gbuffer_layout == GBUFFER_KILLZONE2 ? motion8_decode(motion.xy) : motion.xy;
}

// From RT2 and RT3; false where the surface takes no light.
bool stored_reflectance(vec4 motion, vec4 albedo, out Reflectance r) {
    if (gbuffer_layout == GBUFFER_WIDE) {
        r = reflectance(albedo.rgb, max(albedo.a, 0.0));
        r.f0 *= 1.0 - motion.b;
        return albedo.a >= 0.0;
    }
    r = Reflectance(root_decode(albedo.rgb), vec3(motion.a * motion.a));
    return motion.a > 0.0;
}
#endif
