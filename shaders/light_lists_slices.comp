#version 460
#extension GL_GOOGLE_include_directive : require
// Depth slices between the nearest and the farthest surface of the picture: each as deep as it is far
// away (perspective; an infinite far plane makes no difference), or all alike (orthographic).
#define SLICES_ACCESS
#include "shared/light_cells.glsl"

layout(local_size_x = LIST_GROUP) in;

void main() {
    uint slice = gl_LocalInvocationIndex;
    if (slice > LIST_SLICES)
        return;
    float nearest = 3e38, farthest = 0.0;
    for (uint i = 0u; i < lists.coarse.w; ++i) {
        nearest = min(nearest, coarse_cells[i].nearest);
        farthest = max(farthest, coarse_cells[i].farthest);
    }
    float share = float(slice) / float(LIST_SLICES);
    bool logarithmic = frame.forward.w > 0.5 && nearest > 0.0;
    float z = logarithmic ? nearest * pow(farthest / nearest, share) : mix(nearest, farthest, share);
    // The ends lie a little outside, so that rounding leaves no surface there.
    z = slice == 0u ? nearest * 0.99 : slice == LIST_SLICES ? farthest * 1.01 : z;
    slice_bounds[slice] = linear_depth ? z : device_depth(z);
}
