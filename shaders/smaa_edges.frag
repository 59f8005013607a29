#version 460
#extension GL_GOOGLE_include_directive : require
// SMAA's first pass (Jimenez, Echevarria, Sousa and Gutierrez 2012): where the picture's colour has an edge, at the pixel's
// left and at its upper side: luma alone misses an orange ball before grey. What is fainter than half of the strongest edge around is none (local contrast adaptation, section
// 4.1). Where geometry has no edge, it takes twice the contrast (predication).
#include "shared/displayed.glsl"
#include "shared/geometry_edges.glsl"
#include "shared/smaa.h"

layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform PIXEL_IMAGE picture;
layout(location = 0) out float out_edges;  // SMAA_LEFT | SMAA_ABOVE

const float least = 0.1;              // of 1, the difference of an encoded channel at an edge of geometry
const float within_surfaces = 2.0;    // times that elsewhere
const float local_contrast = 2.0;     // times an edge, what outshines it

vec3 colour_at(ivec2 at) { return displayed_encoded(pixel_read(picture, clamp(at, ivec2(0), last_pixel())).rgb); }

float contrast_of(vec3 a, vec3 b) {
    vec3 difference = abs(a - b);
    return max(difference.r, max(difference.g, difference.b));
}

// Whether geometry has an edge between `at` and the pixel before it.
bool geometry_parts(ivec2 at, ivec2 way) {
    bool parts = max(depth_bend(at - way, way), depth_bend(at, way)) > 1.0;
    return parts || (has_normals && normal_bend(at, at - way) > 0.0);
}

// `way`: from the other pixel to this one. `side`: along the edge.
bool is_edge(ivec2 at, ivec2 way, ivec2 side, vec3 here, vec3 before) {
    float contrast = contrast_of(here, before);
    bool strong = contrast >= least * within_surfaces;
    for (bool once = !strong; once; once = false)
        strong = geometry_parts(at, way);
    // All around both pixels, so that a mirrored picture has the mirrored edges.
    float most = max(contrast_of(before, colour_at(at - 2 * way)), contrast_of(here, colour_at(at + way)));
    for (int i = -1; i <= 1; i += 2)
        most = max(most, max(contrast_of(here, colour_at(at + i * side)), contrast_of(before, colour_at(at - way + i * side))));
    return strong && contrast * local_contrast >= most;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    const ivec2 right = ivec2(1, 0), down = ivec2(0, 1);
    vec3 here = colour_at(at), before = colour_at(at - right), above = colour_at(at - down);
    int edges = 0;
    // Loops: a software device runs both sides of an `if`, but no round of a loop that nobody wants.
    for (bool once = contrast_of(here, before) >= least; once; once = false)
        edges = is_edge(at, right, down, here, before) ? SMAA_LEFT : 0;
    for (bool once = contrast_of(here, above) >= least; once; once = false)
        edges += is_edge(at, down, right, here, above) ? SMAA_ABOVE : 0;
    out_edges = float(edges) / 255.0;
}
