#version 460
#extension GL_GOOGLE_include_directive : require
// Makes room for each cell's lists, one after the other. A cell whose lists do not fit gets the list
// of all lights, which stands first in the buffer; the host reads how much room there should be.
#include "shared/frame.glsl"
#include "shared/light_lists.h"

layout(local_size_x = LIST_SCAN_GROUP) in;
layout(push_constant) uniform ListBlock { LightListConstants lists; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_CELLS, std430) buffer CellBlock { LightCell light_cells[]; };
layout(set = SET_INPUTS, binding = INPUT_LIST_TOTAL, std430) writeonly buffer TotalBlock { uint list_total; };
shared uint sums[LIST_SCAN_GROUP];

// Stays at the largest number instead of beginning at 0 again.
uint add(uint a, uint b) { return a + min(b, ~a); }

void main() {
    uint me = gl_LocalInvocationIndex;
    uint each = (lists.cells.w + LIST_SCAN_GROUP - 1u) / LIST_SCAN_GROUP;
    uint begin = min(me * each, lists.cells.w), end = min(begin + each, lists.cells.w);
    uint sum = 0u;
    for (uint i = begin; i < end; ++i)
        sum = add(sum, light_cells[min(i, lists.cells.w - 1u)].count);
    sums[me] = sum;
    barrier();
    uint first = lists.lights.x + lists.lights.y;
    for (uint i = 0u; i < me; ++i)
        first = add(first, sums[i]);
    for (uint i = begin; i < end; ++i) {
        uint count = light_cells[min(i, lists.cells.w - 1u)].count;
        uint after = add(first, count);
        light_cells[i].first = first;
        if (after > lists.lights.z) {
            light_cells[i].slices = 0u;
            light_cells[i].first = lists.lights.x;
            light_cells[i].count = count == 0u ? 0u : lists.lights.y;
        }
        first = after;
    }
    if (me == LIST_SCAN_GROUP - 1u)
        list_total = first;
}
