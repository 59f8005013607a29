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
layout(constant_id = CONSTANT_SHADOW_EXTREMES) const bool extremes_known = false;
layout(set = SET_FRAME, binding = FRAME_SHADOWS, std430) readonly buffer ShadowBlock { ShadowData shadow_tiles[]; };
layout(set = SET_FRAME, binding = FRAME_SHADOW_TEXELS) uniform samplerBuffer shadow_texels; // as light_texels
layout(set = SET_FRAME, binding = FRAME_SHADOW_SAMPLER) uniform samplerShadow shadow_sampler;
layout(set = SET_INPUTS, binding = INPUT_SHADOW_ATLAS) uniform ONE_SAMPLE_IMAGE shadow_atlas;
// Beside it, where blended surfaces let light through: the share that all of them leave, and the depth of the nearest.
layout(set = SET_INPUTS, binding = INPUT_SHADOW_TRANSMITTANCE) uniform ONE_SAMPLE_IMAGE shadow_transmittance;
// For each cell of the atlas, the nearest and the farthest depth that a lookup from there may meet.
layout(set = SET_INPUTS, binding = INPUT_SHADOW_EXTREMES) uniform ONE_SAMPLE_IMAGE shadow_extremes;

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
                      tile_member(tile, 4), tile_member(tile, 5));
}

// A light's maps.
struct LightShadow {
    uint number; // as in LightData: 0 without
    uint kind;   // SHADOW_…
    vec3 axis;   // of a spot
};

bool has_cascades(LightShadow shadow) { return may_be(LIGHT_KIND_DIRECTIONAL) && shadow.kind == SHADOW_CASCADES; }

// Which of the light's tiles the point lies in; the first of all where none is `wanted`.
uint tile_of(LightShadow shadow, vec3 world, CubeFace face, bool wanted) {
    uint first = wanted ? shadow.number / SHADOW_KINDS - 1u : 0u;
    uint next = shadow.kind == SHADOW_FACES ? number_of(face) : 0u;
    if (may_be(LIGHT_KIND_DIRECTIONAL)) {
        vec4 beyond = vec4(greaterThan(vec4(dot(world, frame.forward.xyz)), shadow_tile(first).ends));
        next = has_cascades(shadow) ? uint(beyond.x + beyond.y + beyond.z) : next;
    }
    return first + (wanted ? next : 0u);
}

// A point and its normal as a tile sees them.
struct InTile {
    ShadowData tile;
    bool cascade;
    vec3 at;      // texels × w, w; of cascades, whose w is 1, texels and depth
    vec3 normal;  // what a metre along the normal adds to `at`
    float sine;   // of the angle between the normal and the tile's axis
};

float w_of(InTile p) { return p.cascade ? 1.0 : p.at.z; }
float metres_a_texel(InTile p) { return p.cascade ? p.tile.scale.x : max(p.at.z, 0.0) / p.tile.place.w; }

// `from_light`: from the light to the point; `nl`: N·L.
InTile in_tile(LightShadow shadow, vec3 world, vec3 n, vec3 from_light, float nl, bool wanted) {
    InTile p;
    CubeFace face = cube_face(from_light);
    p.tile = shadow_tile(tile_of(shadow, world, face, wanted));
    p.cascade = has_cascades(shadow);
    vec3 axes = along_face(face, from_light), normal = along_face(face, n);
    if (may_be(LIGHT_KIND_SPOT)) {
        vec3 right = spot_right(shadow.axis), up = spot_up(shadow.axis);
        bool spot = shadow.kind == SHADOW_SPOT;
        axes = spot ? vec3(dot(right, from_light), dot(up, from_light), dot(shadow.axis, from_light)) : axes;
        normal = spot ? vec3(dot(right, n), dot(up, n), dot(shadow.axis, n)) : normal;
    }
    float half_side = 0.5 * p.tile.place.z;
    p.at = vec3(p.tile.place.w * axes.xy + half_side * axes.z, axes.z);
    p.normal = vec3(p.tile.place.w * normal.xy + half_side * normal.z, normal.z);
    float cosine = normal.z;
    if (may_be(LIGHT_KIND_DIRECTIONAL)) {
        vec4 point = vec4(world, 1.0);
        vec3 rows = vec3(dot(p.tile.across, point), dot(p.tile.down, point), dot(p.tile.away, point));
        p.at = p.cascade ? rows : p.at;
        rows = vec3(dot(p.tile.across.xyz, n), dot(p.tile.down.xyz, n), dot(p.tile.away.xyz, n));
        p.normal = p.cascade ? rows : p.normal;
        cosine = p.cascade ? nl : cosine; // parallel light comes along the axis
    }
    p.sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    return p;
}

// Place in the tile and depth of the point moved off its surface for a disc of this radius.
vec3 moved_place(InTile p, float radius) {
    vec3 at = p.at + metres_a_texel(p) * (radius + margin) * p.sine * p.normal;
    float w = max(p.cascade ? 1.0 : at.z, 1e-6);
    vec3 place = vec3(at.xy, p.cascade ? at.z : SHADOW_NEAR) / w;
    // What rounding does to depth. SwiftShader divides by w to about 12 bits: 0.7 mm a metre.
    place.z += p.cascade ? 2e-6 : 7e-4 * place.z;
    return place;
}

// `tile`: ShadowData::place.
vec2 atlas_texel(vec3 tile, vec2 place) { return tile.xy + clamp(place, vec2(0.5), vec2(tile.z - 0.5)); }

// What all comparisons around the place say: 1 nothing is nearer to the light, 0 everything is; −1: not the same.
float all_say(ShadowData tile, vec3 place) {
    if (!extremes_known)
        return -1.0;
    vec2 depths = texelFetch(shadow_extremes, ivec2(atlas_texel(tile.place.xyz, place.xy)) / SHADOW_CELL, 0).rg;
    float said = place.z > depths.x ? 1.0 : place.z < depths.y ? 0.0 : -1.0;
    return tile.place.z < float(SHADOW_CELL) ? -1.0 : said; // such tiles share a cell
}

// What blended surfaces before the place leave of the light. The stored depth is a half float.
float transmittance(vec2 texel, float depth) {
    vec4 held = texelFetch(shadow_transmittance, ivec2(texel), 0);
    return held.a > depth * (1.0 + 1.0 / 1024.0) ? held.r : 1.0;
}

// Radius of the penumbra, texels, from the mean depth of what lies nearer to the light around the point.
float penumbra(InTile p, float radius, vec2 turn, bool wanted) {
    vec3 place = moved_place(p, radius);
    float sum = 0.0, found = 0.0;
    int taps = wanted ? search_taps : 0;
    for (int i = 0; i < taps; ++i) {
        vec2 spot = place.xy + turn * (radius * sqrt((float(i) + 0.5) / float(search_taps)));
        float depth = texelFetch(shadow_atlas, ivec2(atlas_texel(p.tile.place.xyz, spot)), 0).r;
        float nearer = depth > place.z ? 1.0 : 0.0;
        sum += depth * nearer;
        found += nearer;
        turn = next_turn(turn);
    }
    if (found < 0.5)
        return least_radius;
    float blocker = sum / found;
    float w = w_of(p), size = p.tile.scale.z, nearest = SHADOW_NEAR / blocker;
    float metres =
        p.cascade ? (blocker - place.z) * p.tile.scale.y * size : (w - nearest) * size / max(nearest, 1e-4);
    return clamp(metres / metres_a_texel(p), least_radius, max(radius, least_radius));
}

// Where a point is looked up, [pcf, contact].
struct Lookup {
    vec3 tile;    // ShadowData::place: corner and side
    vec3 place;   // in the tile, and depth
    float radius; // of the disc, texels
    float said;   // all_say(); 1 where nothing is wanted
    bool asks;    // comparisons have to be made
};

// Where comparisons alone cost much, and the search for blockers is none of them: lookups may be made apart.
const bool lookups_apart = shadow_filter == SHADOW_FILTER_PCF;

// `from_light`: from the light to the point; `nl`: N·L.
Lookup lookup(LightShadow shadow, vec3 world, vec3 n, vec3 from_light, float nl, vec2 turn, bool wanted) {
    wanted = wanted && shadow.number > 0u;
    InTile p = in_tile(shadow, world, n, from_light, nl, wanted);
    float largest = shadow_radius(uint(shadow_filter), uint(p.tile.place.z));
    float radius = shadow_filter == SHADOW_FILTER_CONTACT ? penumbra(p, largest, turn, wanted) : least_radius;
    Lookup found;
    found.tile = p.tile.place.xyz;
    found.radius = min(radius, largest);
    found.place = moved_place(p, found.radius);
    found.said = wanted ? all_say(p.tile, found.place) : 1.0;
    found.asks = found.said < 0.0;
    return found;
}

// The mean of all comparisons; of a lane that does not ask, something.
float filtered(Lookup at, vec2 turn) {
    vec2 of_atlas = 1.0 / vec2(textureSize(shadow_atlas, 0));
    float sum = 0.0;
    int i = 0, taps = at.asks ? shadow_taps : 1;
    do { // a software device would run the body once more with the condition in front
        vec2 spot = atlas_texel(at.tile, at.place.xy + turn * (at.radius * sqrt((float(i) + 0.5) / float(shadow_taps))));
        spot = at.asks ? spot : vec2(0.5);
        float left = textureLod(sampler2DShadow(shadow_atlas, shadow_sampler), vec3(spot * of_atlas, at.place.z), 0.0);
        if (shadows_transmit)
            left *= transmittance(spot, at.place.z);
        sum += left;
        turn = next_turn(turn);
    } while (++i < taps);
    return sum / float(shadow_taps);
}

// 1: nothing between the light and the point. Where not `wanted` nothing is looked up.
float unshadowed(LightShadow shadow, vec3 world, vec3 n, vec3 from_light, float nl, vec2 turn, bool wanted) {
    if (shadow_filter == SHADOW_FILTER_HARD) {
        wanted = wanted && shadow.number > 0u;
        InTile p = in_tile(shadow, world, n, from_light, nl, wanted);
        vec3 place = moved_place(p, 0.0);
        vec2 texel = atlas_texel(p.tile.place.xyz, place.xy);
        float left = texelFetch(shadow_atlas, ivec2(texel), 0).r > place.z ? 0.0 : 1.0;
        if (shadows_transmit)
            left *= transmittance(texel, place.z);
        return wanted ? left : 1.0;
    }
    // A software device looks up for all lanes or for none: those that know look where it costs least.
    Lookup at = lookup(shadow, world, n, from_light, nl, turn, wanted);
    float left = filtered(at, turn);
    return at.asks ? left : at.said;
}
#endif
