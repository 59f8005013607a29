// Where geometry has an edge: from depth's second differences and from normals, where the frame has them.
#ifndef PRELIGHT_GEOMETRY_EDGES_GLSL
#define PRELIGHT_GEOMETRY_EDGES_GLSL
#include "shared/gbuffer.glsl"

layout(constant_id = CONSTANT_HAS_NORMALS) const bool has_normals = true;

// Linear over the screen on any plane, so that a plane has no second difference however flat it is seen: device depth,
// or the reciprocal of view depth. 0 where no surface is.
float edge_depth(ivec2 pixel) {
    float stored = read_depth(clamp(pixel, ivec2(0), last_pixel()));
    return linear_depth && frame.forward.w > 0.5 ? (stored > 0.0 ? 1.0 / stored : 0.0) : stored;
}

// How far the depths at both sides of a pixel are from making a plane with its own: the bend in units of a pixel's
// width there. Two faces of a cube that are seen alike make 2.
float depth_bend(float before, float here, float after) {
    float second = abs((before - here) + (after - here));
    if (depth_source == DEPTH_R16F)
        second = max(second - here / 1024.0, 0.0);  // four times what rounding may be off
    float scale = 1.0;
    if (frame.forward.w <= 0.5)
        scale = linear_depth ? 1.0 : 1.0 / frame.depth.x;
    else  // device depth is y / z − x, so that a small change of it is one of y / z
        scale = 1.0 / (linear_depth ? here : here + frame.depth.x);
    float bend = second * scale / pixel_metres(1.0);
    bool all_there = min(before, min(here, after)) > 0.0, nothing = max(before, max(here, after)) <= 0.0;
    return all_there ? bend : nothing ? 0.0 : 1e9;  // a surface ends
}

vec3 edge_normal(ivec2 pixel) { return read_normal(clamp(pixel, ivec2(0), last_pixel())); }

// 1 where normals of neighbours are 37° apart or more, 0 below 26°, and where there is no surface at both.
float normal_bend(vec3 a, vec3 b, bool both) { return both ? clamp((0.9 - dot(a, b)) * 10.0, 0.0, 1.0) : 0.0; }
#endif
