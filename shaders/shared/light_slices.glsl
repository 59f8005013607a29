// Depth slices, shared by all tiles of a frame. Their bounds are values of the depth buffer itself, and
// a pixel finds its slice by comparing: exact, in whatever stage.
#ifndef PRELIGHT_LIGHT_SLICES_GLSL
#define PRELIGHT_LIGHT_SLICES_GLSL
#include "shared/gbuffer.glsl"
#include "shared/sliced.glsl"

#ifndef SLICES_ACCESS
#define SLICES_ACCESS readonly
#endif

// Stored depth where each slice begins, the nearest first; one more for the last one's end.
layout(set = SET_INPUTS, binding = INPUT_DEPTH_SLICES, std430) SLICES_ACCESS buffer SliceBlock { float slice_bounds[]; };

// Of depths as read_depth() gives them.
bool not_before(float stored, float bound) { return linear_depth ? stored >= bound : stored <= bound; }

uint slice_of(float stored) {
    uint slice = 0u;
    for (uint step = LIST_SLICES / 2u; step > 0u; step /= 2u)
        slice += not_before(stored, slice_bounds[slice + step]) ? step : 0u;
    return slice;
}

// View depth.
float slice_begin(uint slice) {
    float stored = slice_bounds[slice];
    return linear_depth ? stored : view_depth(stored);
}
#endif
