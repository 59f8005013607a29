// Where geometry has an edge: from depth's second differences and from normals, where the frame has them.
#ifndef PRELIGHT_GEOMETRY_EDGES_GLSL
#define PRELIGHT_GEOMETRY_EDGES_GLSL
#include "shared/gbuffer.glsl"

layout(constant_id = CONSTANT_HAS_NORMALS) const bool has_normals = true;

// Linear over the screen on any plane, so that a plane has no second difference however flat it is seen: device depth,
// or the reciprocal of view depth. 0 where no surface is.
float edge_depth(ivec2 pixel) {
    float stored = read_depth(clamp(pixel, ivec2(0), last_pixel()));
    return linear_depth && stored > 0.0 && frame.forward.w > 0.5 ? 1.0 / stored : stored;
}

// How far `before` and `after` are from making a plane with what lies between them, in pixels: depth in units of a
// pixel's width there. Two faces of a cube that meet at 45° make 2.
float depth_bend(float before, float here, float after) {
    if (min(before, min(here, after)) <= 0.0)  // a surface ends, or is nowhere
        return max(before, max(here, after)) <= 0.0 ? 0.0 : 1e9;
    float second = abs((before - here) + (after - here));
    if (depth_source == DEPTH_R16F)
        second = max(second - here / 1024.0, 0.0);  // four times what rounding may be off
    if (frame.forward.w <= 0.5)
        return (linear_depth ? second : second / frame.depth.x) / pixel_metres(1.0);
    // Device depth is y / z − x, so that a small change of it is one of y / z.
    float reciprocal = linear_depth ? here : here + frame.depth.x;
    return second / (reciprocal * pixel_metres(1.0));
}

vec3 edge_normal(ivec2 pixel) { return read_normal(clamp(pixel, ivec2(0), last_pixel())); }

// 1 where normals are 37° apart or more, 0 below 26°.
float normal_bend(vec3 a, vec3 b) { return clamp((0.9 - dot(a, b)) * 10.0, 0.0, 1.0); }
#endif
