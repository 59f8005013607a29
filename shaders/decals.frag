#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SAMPLES
// Between the first and the second stage: what one decal makes of the surface under a pixel, blended over what
// earlier decals made of it. Alpha of the first two targets is how much of the surface itself is left.
#include "shared/decal_box.glsl"
#include "shared/gbuffer.glsl"
#include "shared/material_set.glsl"

layout(early_fragment_tests) in;
layout(push_constant) uniform DecalBlock { DecalConstants decal; };
layout(location = 0) out vec4 out_colour;   // base colour
layout(location = 1) out vec4 out_normal;   // world space
layout(location = 2) out vec4 out_roughness; // r: roughness; g: nothing is added, so that it becomes what is left
layout(location = 3) out vec4 out_metallic;  // r

// How the place changes from this pixel to the next one to the right or below: to the neighbour on the side where it
// changes less, for the other may show something else. What derivatives between pixels give there would be a seam.
vec3 step_along(ivec2 pixel, ivec2 along, vec3 world) {
    ivec2 last = last_pixel();
    vec3 after, before;
    bool there_after = read_position(min(pixel + along, last), after);
    bool there_before = read_position(max(pixel - along, ivec2(0)), before);
    after -= world;
    before = world - before;
    // At the picture's edge one of them is 0.
    float a = there_after ? dot(after, after) : 0.0, b = there_before ? dot(before, before) : 0.0;
    return a > 0.0 && (a <= b || b == 0.0) ? after : b > 0.0 ? before : vec3(0.0);
}

vec2 ddx, ddy; // of the picture's place

vec4 look_up(sampler2D map, int binding, vec2 uv) {
    vec2 place = transformed(binding, uv) + material.uv_offset[binding - 1].xy;
    return textureGrad(map, place, transformed(binding, ddx), transformed(binding, ddy));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef SAMPLES
    pixel_sample = gl_SampleID;
#endif
    vec3 world;
    bool surface = read_position(pixel, world);
    vec3 place = in_decal_box(decal, vec4(world, 1.0));
    vec3 n = read_normal(pixel);
    float t = decal_presence(decal, place, n);
    if (!surface || t <= 0.0)
        discard;

    vec2 uv = decal_uv(place);
    ddx = in_decal_box(decal, vec4(step_along(pixel, ivec2(1, 0), world), 0.0)).xy * vec2(1.0, -1.0);
    ddy = in_decal_box(decal, vec4(step_along(pixel, ivec2(0, 1), world), 0.0)).xy * vec2(1.0, -1.0);

    vec4 base = material.base_colour;
    if (has(FEATURE_BASE_COLOUR_TEXTURE))
        base *= look_up(base_colour_map, MATERIAL_BASE_COLOUR, uv);
    if (has(FEATURE_ALPHA_MASK)) {
        if (base.a < material.emissive.w)
            discard;
        base.a = 1.0;
    }
    vec2 factors = material.factors.xy;
    if (has(FEATURE_METALLIC_ROUGHNESS_TEXTURE))
        factors *= look_up(metallic_roughness_map, MATERIAL_METALLIC_ROUGHNESS, uv).bg;
    vec3 mapped = n;
    if (has(FEATURE_NORMAL_TEXTURE)) {
        vec3 texel = look_up(normal_map, MATERIAL_NORMAL, uv).xyz * 2.0 - 1.0;
        texel.xy *= material.factors.z;
        mapped = decal_mapped_normal(decal, n, texel);
    }
    // Blended by their alphas, whether the target has one or not.
    vec3 cover = decal_cover(decal, base.a, t);
    out_colour = vec4(base.rgb, 1.0) * cover.x;
    out_normal = vec4(mapped, 1.0) * cover.y;
    out_roughness = vec4(factors.y, 0.0, 0.0, 1.0) * cover.z;
    out_metallic = vec4(factors.x, 0.0, 0.0, 1.0) * cover.x;
}
