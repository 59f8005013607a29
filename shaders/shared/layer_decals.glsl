// Decals on a blended surface. Included where LAYER_DECALS is defined: by passes that light objects where they draw
// them. Textures take their levels from the surface itself, for its neighbours are its own.
#ifndef PRELIGHT_LAYER_DECALS_GLSL
#define PRELIGHT_LAYER_DECALS_GLSL
#include "shared/decal_box.glsl"
#include "shared/layer_decals.h"
#include "shared/surface.glsl"

layout(set = SET_LAYER_DECALS, binding = LAYER_DECAL_LIST, std140) uniform LayerDecalBlock { LayerDecalList layer_decals; };
#define LAYER_DECAL_TEXTURES(k)                                                                             \
    layout(set = SET_LAYER_DECALS, binding = LAYER_DECAL_MAPS + 3 * k) uniform sampler2D decal_base_##k;        \
    layout(set = SET_LAYER_DECALS, binding = LAYER_DECAL_MAPS + 3 * k + 1) uniform sampler2D decal_factors_##k; \
    layout(set = SET_LAYER_DECALS, binding = LAYER_DECAL_MAPS + 3 * k + 2) uniform sampler2D decal_normals_##k;
LAYER_DECAL_TEXTURES(0)
LAYER_DECAL_TEXTURES(1)
LAYER_DECAL_TEXTURES(2)
LAYER_DECAL_TEXTURES(3)

vec2 place_in_map(LayerDecal decal, int map, vec2 uv) {
    vec4 m = decal.uv_linear[map];
    return m.xy * uv.x + m.zw * uv.y + decal.uv_offset[map].xy;
}

// `n`: the surface's own normal; `mixed`: what earlier decals made of it, of any length.
void lay_decal(inout Surface s, inout vec3 mixed, vec3 n, vec3 world, uint k, sampler2D base_map, sampler2D factors_map,
               sampler2D normal_map) {
    LayerDecal decal = layer_decals.decals[k];
    vec3 place = in_decal_box(decal.box, vec4(world, 1.0));
    vec2 uv = decal_uv(place);
    // Before any branch: levels come from the neighbours' places.
    vec4 base_texel = texture(base_map, place_in_map(decal, 0, uv));
    vec2 factor_texel = texture(factors_map, place_in_map(decal, 1, uv)).bg;
    vec3 normal_texel = texture(normal_map, place_in_map(decal, 2, uv)).xyz * 2.0 - 1.0;

    float t = decal_presence(decal.box, place, n);
    if (k >= layer_decals.count.x || t <= 0.0)
        return;
    vec4 base = decal.base_colour * base_texel; // of what has no texture, a white one
    if ((decal.features.x & FEATURE_ALPHA_MASK) != 0u)
        base.a = base.a < decal.factors.w ? 0.0 : 1.0;
    vec3 mapped = n;
    if ((decal.features.x & FEATURE_NORMAL_TEXTURE) != 0u) {
        normal_texel.xy *= decal.factors.z;
        mapped = decal_mapped_normal(decal.box, n, normal_texel);
    }
    vec3 cover = decal_cover(decal.box, base.a, t);
    s.base = mix(s.base, base.rgb, cover.x);
    s.metallic = mix(s.metallic, decal.factors.x * factor_texel.x, cover.x);
    s.roughness = mix(s.roughness, decal.factors.y * factor_texel.y, cover.z);
    mixed = mix(mixed, mapped, cover.y);
}

void apply_layer_decals(inout Surface s, vec3 world) {
    vec3 n = s.normal, mixed = n;
    lay_decal(s, mixed, n, world, 0u, decal_base_0, decal_factors_0, decal_normals_0);
    lay_decal(s, mixed, n, world, 1u, decal_base_1, decal_factors_1, decal_normals_1);
    lay_decal(s, mixed, n, world, 2u, decal_base_2, decal_factors_2, decal_normals_2);
    lay_decal(s, mixed, n, world, 3u, decal_base_3, decal_factors_3, decal_normals_3);
    s.normal = normalize(mixed);
}
#endif
