// What a decal's box makes of a point of a surface, wherever the decal is laid on it.
#ifndef PRELIGHT_DECAL_BOX_GLSL
#define PRELIGHT_DECAL_BOX_GLSL
#include "shared/decal.h"

// `v`: world space relative to the camera, w 1 of a point, 0 of a direction. A point within the box: ±0.5.
vec3 in_decal_box(DecalConstants box, vec4 v) {
    return vec3(dot(box.box_row[0], v), dot(box.box_row[1], v), dot(box.box_row[2], v));
}

// Of the decal's picture, whose top left is 0.
vec2 decal_uv(vec3 place) { return vec2(place.x + 0.5, 0.5 - place.y); }

vec3 decal_axis(DecalConstants box, int axis) {
    return vec3(box.world_row[0][axis], box.world_row[1][axis], box.world_row[2][axis]);
}

// How far the decal is there at a point with the normal n, before the curve: 0 … 1; 0 outside of its box.
float decal_presence(DecalConstants box, vec3 place, vec3 n) {
    float t = clamp(dot(n, normalize(decal_axis(box, 2))) * box.fade.x + box.fade.y, 0.0, 1.0);
    return any(greaterThan(abs(place), vec3(0.5))) ? 0.0 : t;
}

// How much of what was there is covered: of colour, normal, roughness.
vec3 decal_cover(DecalConstants box, float alpha, float t) {
    return box.opacity.xyz * (alpha * t * t * (3.0 - 2.0 * t));
}

// `texel`: of the normal map, scaled, in the frame of the surface's own normal n. Where n is the X axis, or they meet,
// the fade has left nothing.
vec3 decal_mapped_normal(DecalConstants box, vec3 n, vec3 texel) {
    vec3 right = decal_axis(box, 0), up = decal_axis(box, 1);
    vec3 tangent = normalize(right - n * dot(n, right));
    vec3 bitangent = normalize(up - n * dot(n, up) - tangent * dot(tangent, up));
    return normalize(tangent * texel.x + bitangent * texel.y + n * texel.z);
}
#endif
