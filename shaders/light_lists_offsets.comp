#version 460
#extension GL_GOOGLE_include_directive : require
// Makes room for each cell's lists, one after the other, behind what stands in the entries already. A cell whose
// lists do not fit gets the list of all lights, which stands first in the buffer; the host reads how much room
// there should be.
#include "shared/bindings.h"
#include "shared/light_lists.h"

layout(constant_id = CONSTANT_LIST_COARSE) const bool coarse = false; // the coarse cells, which come first
layout(constant_id = CONSTANT_LIST_MASKED) const bool masked = false; // and their tiles' masks
layout(local_size_x = LIST_SCAN_GROUP) in;
layout(push_constant) uniform ListBlock { LightListConstants lists; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_CELLS, std430) buffer CellBlock { LightCell cells[]; };
layout(set = SET_INPUTS, binding = INPUT_LIST_TOTAL, std430) buffer TotalBlock { uint list_total; };
shared uint sums[LIST_SCAN_GROUP];

// Stays at the largest number instead of beginning at 0 again.
uint add(uint a, uint b) { return a + min(b, ~a); }

// What a list of `count` lights takes, masks included.
uint room_of(uint count) {
    uint words = masked ? (count / 32u + (count % 32u > 0u ? 1u : 0u)) : 0u;
    return words > 0xffffffffu / LIST_GROUP ? 0xffffffffu : add(count, words * LIST_GROUP);
}

void main() {
    uint me = gl_LocalInvocationIndex;
    uint all = coarse ? lists.coarse.w : lists.cells.w;
    uint each = (all + LIST_SCAN_GROUP - 1u) / LIST_SCAN_GROUP;
    uint begin = min(me * each, all), end = min(begin + each, all);
    uint sum = 0u;
    for (uint i = begin; i < end; ++i)
        sum = add(sum, room_of(cells[min(i, all - 1u)].count));
    sums[me] = sum;
    uint first = coarse ? lists.lights.x + lists.lights.y : list_total;
    barrier();
    for (uint i = 0u; i < me; ++i)
        first = add(first, sums[i]);
    for (uint i = begin; i < end; ++i) {
        uint count = cells[min(i, all - 1u)].count;
        uint after = add(first, room_of(count));
        cells[i].first = first;
        if (after > lists.lights.z) {
            cells[i].slices = 0u;
            cells[i].first = lists.lights.x;
            cells[i].count = count == 0u ? 0u : lists.lights.y;
        }
        first = after;
    }
    if (me == LIST_SCAN_GROUP - 1u)
        list_total = first;
}
