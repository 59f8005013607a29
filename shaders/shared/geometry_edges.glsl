// Where geometry has an edge: from depth's second differences and from normals, where the frame has them.
#ifndef PRELIGHT_GEOMETRY_EDGES_GLSL
#define PRELIGHT_GEOMETRY_EDGES_GLSL
#include "shared/gbuffer.glsl"

layout(constant_id = CONSTANT_HAS_NORMALS) const bool has_normals = true;

// Linear over the screen on any plane, so that a plane has no second difference however flat it is seen: device depth,
// or the reciprocal of view depth. 0 where no surface is.
float edge_depth(ivec2 pixel) {
    float stored = read_depth(pixel);
    return linear_depth && stored > 0.0 && frame.forward.w > 0.5 ? 1.0 / stored : stored;
}

bool is_outside(ivec2 pixel) { return pixel != clamp(pixel, ivec2(0), last_pixel()); }

// How far the depths at both sides of a pixel are from making a plane with its own: the bend in units of a pixel's width
// there. Two faces of a cube that are seen alike make 2. At the picture's borders nobody knows, and there is none.
float depth_bend(ivec2 at, ivec2 way) {
    if (is_outside(at - way) || is_outside(at + way))
        return 0.0;
    float before = edge_depth(at - way), here = edge_depth(at), after = edge_depth(at + way);
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

// 1 where normals of neighbours are 37° apart or more, 0 below 26°, and where one has no surface.
float normal_bend(ivec2 at, ivec2 other) {
    if (is_outside(other) || edge_depth(at) <= 0.0 || edge_depth(other) <= 0.0)
        return 0.0;
    return clamp((0.9 - dot(read_normal(at), read_normal(other))) * 10.0, 0.0, 1.0);
}
#endif
