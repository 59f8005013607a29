#version 460
#extension GL_GOOGLE_include_directive : require
// variants: GRID_CELLS
// Each light marks the coarse cells that it may reach, and is counted there. Marks are bits, so the order in which
// invocations set them does not matter.
#include "shared/light_cells.glsl"

layout(local_size_x = LIST_GROUP) in;

void main() {
    uint index = gl_GlobalInvocationID.x;
    uint all = lists.lights.x + lists.lights.y;
    if (index >= all)
        return;
    index = min(index, all - 1u);
    uint light_index = light_order[lists.round.x + index];
    light_entries[index] = light_index;
    if (index < lists.lights.x)
        return;
    uint bit = index - min(index, lists.lights.x);
    LightBounds light = bounds_of(lights[light_index]);
    uint depths = depths_of(light);
    ivec3 low, high;
    light_extent(light, low, high);
    ivec3 size = max(high - low + 1, ivec3(0));
    int left = size.x * size.y * size.z;
    ivec3 step = ivec3(0);
    do { // one loop, left at its end: see light_list.comp
        uvec3 at = uvec3(clamp(low + step, ivec3(0), ivec3(lists.coarse.xyz) - 1));
        uint coarse = index_in(at, lists.coarse.xyz);
        LightCell cell = coarse_cells[coarse];
        if (left > 0 && holds_depths(cell, depths) && may_reach_coarse(at, cell, light)) {
            uint start = mask_start(coarse);
            atomicOr(light_masks[start + bit / 1024u], 1u << (bit / 32u & 31u));
            atomicOr(light_masks[start + summary_words() + bit / 32u], 1u << (bit & 31u));
            atomicAdd(coarse_cells[coarse].count, 1u);
        }
        ++step.x;
        step = step.x < size.x ? step : ivec3(0, step.y + 1, step.z);
        step = step.y < size.y ? step : ivec3(0, 0, step.z + 1);
    } while (--left > 0);
}
