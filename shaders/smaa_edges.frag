#version 460
#extension GL_GOOGLE_include_directive : require
// SMAA's first pass (Jimenez, Echevarria, Sousa and Gutierrez 2012, "Edge detection"): where the picture's colour has
// an edge, at the pixel's left and at its upper side; luma alone misses an orange ball before grey. What is fainter
// than half of the strongest edge around is none (local contrast adaptation). Where geometry has no edge, it takes
// twice the contrast (predication).
#include "shared/displayed.glsl"
#include "shared/geometry_edges.glsl"
#include "shared/smaa.h"

layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform PIXEL_IMAGE picture;
layout(location = 0) out float out_edges;  // SMAA_LEFT | SMAA_ABOVE

const float least = 0.1;            // of 1, the difference of an encoded channel at an edge of geometry
const float within_surfaces = 2.0;  // times that elsewhere
const float local_contrast = 2.0;   // times an edge, what outshines it

vec3 colour_at(ivec2 at) { return displayed_encoded(pixel_read(picture, clamp(at, ivec2(0), last_pixel())).rgb); }

float contrast_of(vec3 a, vec3 b) {
    vec3 difference = abs(a - b);
    return max(difference.r, max(difference.g, difference.b));
}

// Whether geometry has an edge between `at` and the pixel before it.
bool geometry_parts(ivec2 at, ivec2 way) {
    float depths[4];
    for (int i = 0; i < 4; ++i)
        depths[i] = edge_depth(at + (i - 2) * way);
    // At the picture's borders nobody knows how a plane goes on.
    ivec2 first = at - 2 * way, last = at + way;
    bool before = first == max(first, ivec2(0)) && depth_bend(depths[0], depths[1], depths[2]) > 1.0;
    bool after = last == min(last, last_pixel()) && depth_bend(depths[1], depths[2], depths[3]) > 1.0;
    bool there = min(depths[1], depths[2]) > 0.0;
    bool bends = has_normals && normal_bend(edge_normal(at - way), edge_normal(at), there) > 0.0;
    return before || after || bends;
}

// `way`: from the other pixel to this one. `side`: along the edge.
bool is_edge(ivec2 at, ivec2 way, ivec2 side, vec3 here, vec3 before) {
    float contrast = contrast_of(here, before);
    // All around both pixels, so that a mirrored picture has the mirrored edges.
    float most = max(contrast_of(before, colour_at(at - 2 * way)), contrast_of(here, colour_at(at + way)));
    for (int i = -1; i <= 1; i += 2) {
        most = max(most, contrast_of(here, colour_at(at + i * side)));
        most = max(most, contrast_of(before, colour_at(at - way + i * side)));
    }
    bool is = contrast * local_contrast >= most;
    if (is && contrast < least * within_surfaces)
        is = geometry_parts(at, way);
    return is;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    const ivec2 right = ivec2(1, 0), down = ivec2(0, 1);
    vec3 here = colour_at(at), before = colour_at(at - right), above = colour_at(at - down);
    int edges = 0;
    if (contrast_of(here, before) >= least)
        edges = is_edge(at, right, down, here, before) ? SMAA_LEFT : 0;
    if (contrast_of(here, above) >= least)
        edges += is_edge(at, down, right, here, above) ? SMAA_ABOVE : 0;
    out_edges = float(edges) / 255.0;
}
