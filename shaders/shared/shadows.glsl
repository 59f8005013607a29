// How much of a light comes to a point past its shadow casters: shadow maps in an atlas, percentage-closer
// filtering (Reeves, Salesin, Cook 1987) over a disc that turns from pixel to pixel, or a disc whose size follows
// from the blockers found (Fernando, "Percentage-Closer Soft Shadows", 2005).
//
// Bias: the point moves along its normal by what the disc and a texel of the map can be off on a plane through it.
// Texels lie across the tile's axis: that is (radius + √2) texels · sin(N, axis). More would be a gap where
// things touch.
#ifndef PRELIGHT_SHADOWS_GLSL
#define PRELIGHT_SHADOWS_GLSL
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/frame.glsl"
#include "shared/light_kinds.glsl"
#include "shared/shadow.h"

layout(constant_id = CONSTANT_SHADOW_FILTER) const int shadow_filter = SHADOW_FILTER_PCF;
layout(constant_id = CONSTANT_SHADOWS_TRANSMIT) const bool shadows_transmit = false;
layout(set = SET_FRAME, binding = FRAME_SHADOWS, std430) readonly buffer ShadowBlock { ShadowData shadow_tiles[]; };
layout(set = SET_FRAME, binding = FRAME_SHADOW_TEXELS) uniform samplerBuffer shadow_texels; // as light_texels
layout(set = SET_FRAME, binding = FRAME_SHADOW_SAMPLER) uniform samplerShadow shadow_sampler;
layout(set = SET_INPUTS, binding = INPUT_SHADOW_ATLAS) uniform ONE_SAMPLE_IMAGE shadow_atlas;
// Beside it, where blended surfaces let light through: the share that all of them leave, and the depth of the nearest.
layout(set = SET_INPUTS, binding = INPUT_SHADOW_TRANSMITTANCE) uniform ONE_SAMPLE_IMAGE shadow_transmittance;

const int shadow_taps = shadow_filter == SHADOW_FILTER_CONTACT ? 16 : 8;
const int search_taps = 12;
const float golden_cos = -0.73736888, golden_sin = 0.67549029; // of the golden angle, 2.39996
const float margin = shadow_filter == SHADOW_FILTER_HARD ? 0.70710678 : 1.41421356; // to the farthest texel, texels
const float least_radius = shadow_filter == SHADOW_FILTER_HARD ? 0.0 : 1.5; // texels

// The unit vector that turns a pixel's disc: interleaved gradient noise (Jimenez 2014).
vec2 disc_turn(vec2 pixel) {
    float angle = 6.2831853 * fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    return vec2(cos(angle), sin(angle));
}

vec2 next_turn(vec2 t) { return vec2(t.x * golden_cos - t.y * golden_sin, t.x * golden_sin + t.y * golden_cos); }

// Members of a tile: what no one reads is not fetched.
vec4 tile_member(uint tile, int member) { return texelFetch(shadow_texels, SHADOW_TEXELS * int(tile) + member); }
ShadowData shadow_tile(uint tile) {
    if (!lights_as_texels)
        return shadow_tiles[tile];
    return ShadowData(tile_member(tile, 0), tile_member(tile, 1), tile_member(tile, 2), tile_member(tile, 3),
                      tile_member(tile, 4), tile_member(tile, 5), tile_member(tile, 6));
}

// Which of the light's tiles the point lies in; `from_light`: from the light to the point.
uint tile_of(uint shadow, vec3 world, vec3 from_light) {
    uint kind = shadow % SHADOW_KINDS, first = shadow / SHADOW_KINDS - 1u, tile = first;
    if (may_be(LIGHT_KIND_DIRECTIONAL)) {
        vec4 beyond = vec4(greaterThan(vec4(dot(world, frame.forward.xyz)), shadow_tile(first).ends));
        tile += kind == SHADOW_CASCADES ? uint(beyond.x + beyond.y + beyond.z) : 0u;
    }
    vec3 size = abs(from_light);
    bool x = size.x >= size.y && size.x >= size.z, y = size.y >= size.z;
    uint face = x ? (from_light.x < 0.0 ? 1u : 0u) : y ? (from_light.y < 0.0 ? 3u : 2u) : (from_light.z < 0.0 ? 5u : 4u);
    return tile + (kind == SHADOW_FACES ? face : 0u);
}

bool is_cascade(ShadowData tile) { return tile.scale.z > 0.0; }
float w_of(ShadowData tile, vec3 at) { return is_cascade(tile) ? 1.0 : at.z; }

// Place in the tile and depth of a point moved off its surface for a disc of this radius. `at`: what the tile's rows make
// of the point.
vec3 moved_place(ShadowData tile, vec3 at, vec3 n, float sine, float radius) {
    float offset = (tile.scale.x + tile.scale.y * max(w_of(tile, at), 0.0)) * (radius + margin) * sine;
    at += offset * vec3(dot(tile.across.xyz, n), dot(tile.down.xyz, n), dot(tile.away.xyz, n));
    float w = max(w_of(tile, at), 1e-6);
    vec3 place = vec3(at.xy, is_cascade(tile) ? at.z : tile.scale.w) / w;
    // What rounding does to depth. SwiftShader divides by w to about 12 bits: 0.7 mm a metre.
    place.z += is_cascade(tile) ? 2e-6 : 7e-4 * place.z;
    return place;
}

vec2 atlas_texel(ShadowData tile, vec2 place) { return tile.place.xy + clamp(place, vec2(0.5), vec2(tile.place.z - 0.5)); }

// What blended surfaces before the place leave of the light. The stored depth is a half float.
float transmittance(vec2 texel, float depth) {
    vec4 held = texelFetch(shadow_transmittance, ivec2(texel), 0);
    return held.a > depth * (1.0 + 1.0 / 1024.0) ? held.r : 1.0;
}

// Radius of the penumbra, texels, from the mean depth of what lies nearer to the light around the point.
float penumbra(ShadowData tile, vec3 at, vec3 n, float sine, vec2 turn, bool wanted) {
    float radius = tile.place.w;
    vec3 place = moved_place(tile, at, n, sine, radius);
    float sum = 0.0, found = 0.0;
    int taps = wanted ? search_taps : 0;
    for (int i = 0; i < taps; ++i) {
        vec2 spot = place.xy + turn * (radius * sqrt((float(i) + 0.5) / float(search_taps)));
        float depth = texelFetch(shadow_atlas, ivec2(atlas_texel(tile, spot)), 0).r;
        float nearer = depth > place.z ? 1.0 : 0.0;
        sum += depth * nearer;
        found += nearer;
        turn = next_turn(turn);
    }
    if (found < 0.5)
        return least_radius;
    float blocker = sum / found;
    float w = w_of(tile, at), size = tile.light.x, nearest = tile.scale.w / blocker;
    float metres = is_cascade(tile) ? (blocker - place.z) * tile.scale.z * size : (w - nearest) * size / max(nearest, 1e-4);
    return clamp(metres / (tile.scale.x + tile.scale.y * w), least_radius, max(radius, least_radius));
}

// 1: nothing between the light and the point. `shadow`: as in LightData; `nl`: N·L; where not `wanted` nothing is looked up.
float unshadowed(uint shadow, vec3 world, vec3 n, vec3 from_light, float nl, vec2 turn, bool wanted) {
    wanted = wanted && shadow > 0u;
    ShadowData tile = shadow_tile(tile_of(wanted ? shadow : SHADOW_KINDS, world, from_light));
    vec4 homogeneous = vec4(world, 1.0);
    vec3 at = vec3(dot(tile.across, homogeneous), dot(tile.down, homogeneous), dot(tile.away, homogeneous));
    // Parallel light comes along the axis; else the axis is what w grows along.
    float cosine = is_cascade(tile) ? nl : dot(n, tile.away.xyz);
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    if (shadow_filter == SHADOW_FILTER_HARD) {
        vec3 place = moved_place(tile, at, n, sine, 0.0);
        vec2 texel = atlas_texel(tile, place.xy);
        float depth = texelFetch(shadow_atlas, ivec2(texel), 0).r, left = depth > place.z ? 0.0 : 1.0;
        if (shadows_transmit)
            left *= transmittance(texel, place.z);
        return wanted ? left : 1.0;
    }
    float radius = least_radius;
    if (shadow_filter == SHADOW_FILTER_CONTACT)
        radius = penumbra(tile, at, n, sine, turn, wanted);
    radius = min(radius, tile.place.w);
    vec3 place = moved_place(tile, at, n, sine, radius);
    vec2 of_atlas = 1.0 / vec2(textureSize(shadow_atlas, 0));
    float sum = 0.0;
    int i = 0, taps = wanted ? shadow_taps : 1;
    do { // a software device would run the body once more with the condition in front
        vec2 spot = atlas_texel(tile, place.xy + turn * (radius * sqrt((float(i) + 0.5) / float(shadow_taps))));
        float left = textureLod(sampler2DShadow(shadow_atlas, shadow_sampler), vec3(spot * of_atlas, place.z), 0.0);
        if (shadows_transmit)
            left *= transmittance(spot, place.z);
        sum += left;
        turn = next_turn(turn);
    } while (++i < taps);
    return wanted ? sum / float(shadow_taps) : 1.0;
}
#endif
