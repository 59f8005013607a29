// How much a light sends in a direction: its cookie and its measured profile, which multiply; docs/cookies.md defines
// both. Their maps lie in one image, level by level, so that one texture binding serves all lights; the level of a
// cookie follows from the angle that a pixel covers, which compute shaders know as well as others.
#ifndef PRELIGHT_LIGHT_DISTRIBUTION_GLSL
#define PRELIGHT_LIGHT_DISTRIBUTION_GLSL
#include "shared/pixel_reads.glsl"

layout(set = SET_FRAME, binding = FRAME_DISTRIBUTIONS, std430) readonly buffer DistributionBlock { DistributionData distributions[]; };
layout(set = SET_FRAME, binding = FRAME_DISTRIBUTION_LEVELS, std430) readonly buffer DistributionLevelBlock { DistributionLevel distribution_levels[]; };
layout(set = SET_FRAME, binding = FRAME_DISTRIBUTION_MAPS) uniform sampler2D distribution_maps;

const float half_turn = 3.14159265;

// Metres that a pixel covers on a surface there, along its longer side; `nv`: N·V.
float pixel_on_surface(vec3 world, float nv) {
    return pixel_metres(dot(world, frame.forward.xyz)) / max(abs(nv), 0.1);
}

// Place in a map, 0 … 1 from its left and top; z: texels of level 0 that a radian covers there, relative to those
// that DistributionData::detail names; w: number of the map.
vec4 spot_place(vec3 d, float inverse_tangent) {
    vec2 across = d.xy / max(-d.z, 1e-6);
    return vec4(clamp(vec2(0.5) + vec2(0.5, -0.5) * inverse_tangent * across, 0.0, 1.0), 1.0 + dot(across, across), 0.0);
}

vec4 sphere_place(vec3 d) {
    float up = clamp(d.y, -1.0, 1.0);
    vec2 place = vec2(0.5 + 0.5 / half_turn * atan(d.x, -d.z), acos(up) / half_turn);
    return vec4(place, 1.0 / max(sqrt(1.0 - up * up), 0.25), 0.0); // meridians draw together towards the poles
}

vec4 cube_place(vec3 d) {
    vec3 size = abs(d);
    bool x = size.x >= size.y && size.x >= size.z, y = !x && size.y >= size.z;
    float axis = x ? d.x : y ? d.y : d.z, away = abs(axis), side = axis < 0.0 ? -1.0 : 1.0;
    // +X −X +Y −Y +Z −Z, as the light sees them.
    vec2 across = x ? vec2(d.z * side, d.y) : y ? vec2(d.x, d.z * side) : vec2(-d.x * side, d.y);
    float number = (x ? 0.0 : y ? 2.0 : 4.0) + (axis < 0.0 ? 1.0 : 0.0);
    return vec4(vec2(0.5) + vec2(0.5, -0.5) * across / away, 1.0 / (away * away), number);
}

vec3 map_texel(vec2 texel) {
    return textureLod(distribution_maps, texel / vec2(textureSize(distribution_maps, 0)), 0.0).rgb;
}

// Between the two levels whose texels are nearest to what a pixel covers.
vec3 cookie_at(uint index, vec4 place, float spread) {
    vec4 cookie = distributions[index].cookie;
    float lod = clamp(log2(max(spread * distributions[index].detail.x * place.z, 1.0)), 0.0, cookie.z), level = floor(lod);
    uint first = uint(cookie.y + place.w * (cookie.z + 1.0) + level);
    vec4 finer = distribution_levels[first].rectangle;
    vec3 colour = map_texel(finer.xy + place.xy * finer.zw);
    if (lod > level) {
        vec4 coarser = distribution_levels[first + 1u].rectangle;
        colour = mix(colour, map_texel(coarser.xy + place.xy * coarser.zw), lod - level);
    }
    return colour;
}

float profile_at(uint index, vec3 d) {
    vec2 limits = distributions[index].detail.zw;
    vec4 profile = distributions[index].profile;
    float off_axis = acos(clamp(-d.z, -1.0, 1.0)), around = atan(d.y, d.x);
    around += around < 0.0 ? 2.0 * half_turn : 0.0;
    bool lit = off_axis >= limits.x && off_axis <= limits.y;
    return lit ? map_texel(profile.xz + vec2(around, off_axis) * profile.yw).r : 0.0;
}

// Factor of the light's colour; `number`: that of its record, from 1. `direction`: unit, from the light; `spread`: radians
// that a pixel at the lit point covers, seen from the light.
//
// Members are read where they are needed: each costs a software device a load for each invocation.
vec3 light_distribution(uint number, vec3 direction, float spread) {
    uint index = number - 1u;
    vec3 right = distributions[index].right.xyz, up = distributions[index].up.xyz;
    vec3 d = vec3(dot(direction, right), dot(direction, up), dot(direction, cross(right, up)));
    int kind = int(distributions[index].cookie.x);
    vec3 factor = vec3(1.0);
    if (kind == COOKIE_SPOT)
        factor = d.z < 0.0 ? cookie_at(index, spot_place(d, distributions[index].cookie.w), spread) : vec3(0.0);
    if (kind == COOKIE_SPHERE)
        factor = cookie_at(index, sphere_place(d), spread);
    if (kind == COOKIE_CUBE)
        factor = cookie_at(index, cube_place(d), spread);
    if (distributions[index].detail.y > 0.0)
        factor *= profile_at(index, d);
    return factor;
}
#endif
