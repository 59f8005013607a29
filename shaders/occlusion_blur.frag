#version 460
#extension GL_GOOGLE_include_directive : require
// Brings the 4×4 directions of occlusion_search.frag together, along one axis: five pixels, the outer ones half, so that
// each of the four directions counts alike. What lies off the pixel's own plane takes no part.
#include "shared/occlusion.glsl"

layout(constant_id = CONSTANT_OCCLUSION_AXIS) const int axis = 0; // 0: rows, 1: columns
layout(set = SET_INPUTS, binding = INPUT_OCCLUSION) uniform PIXEL_IMAGE occlusion;
layout(location = 0) out vec2 out_visibility;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(occlusion, 0) - 1, way = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
    vec2 line[5];
    for (int i = 0; i < 5; ++i)
        line[i] = pixel_read(occlusion, clamp(at + (i - 2) * way, ivec2(0), last)).xy;
    float here = line[2].y, z = view_depth_of(max(here, 1e-9));
    // The plane's slope: the smaller of both sides', and none that a plane does not have unless it is seen within 2°.
    float before = here - line[1].y, after = line[3].y - here;
    float slope = abs(before) < abs(after) ? before : after;
    float metres = z / max(here, 1e-9); // of view depth, for a small change of what is stored
    float steepest = 25.0 * pixel_metres(z) * float(occlusion_scale);
    if (abs(slope) * metres > steepest)
        slope = 0.0;
    float tolerance = 0.03 * occlusion_radius + 0.5 * abs(slope) * metres;
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < 5; ++i) {
        float off = abs(line[i].y - here - float(i - 2) * slope) * metres;
        float weight = (i == 0 || i == 4 ? 0.5 : 1.0) * (line[i].y > 0.0 ? clamp(2.0 - 2.0 * off / tolerance, 0.0, 1.0) : 0.0);
        weight = i == 2 ? 1.0 : weight;
        sum += weight * line[i].x;
        weights += weight;
    }
    out_visibility = here > 0.0 ? vec2(sum / weights, here) : vec2(1.0, 0.0);
}
