// Walking light lists, wherever a pixel's cell comes from: list_size() lights, listed_light(i) each.
#ifndef PRELIGHT_LIGHT_LISTS_GLSL
#define PRELIGHT_LIGHT_LISTS_GLSL
#include "shared/frame.glsl"
#include "shared/sliced.glsl"

layout(push_constant) uniform ListBlock { LightListConstants lists; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_CELLS, std430) readonly buffer CellBlock { LightCell light_cells[]; };
// All lights of the frame, then lists.
layout(set = SET_INPUTS, binding = INPUT_LIGHT_ENTRIES, std430) readonly buffer EntryBlock { uint light_entries[]; };

struct LightList {
    uint count;
    uint everywhere; // the first of them are the lights that are in every list
    uint first;
};

LightList list_of(uint cell_index, uint slice) {
    LightCell cell = light_cells[cell_index];
    LightList list = LightList(cell.count, lists.lights.x, cell.first);
    if (sliced && cell.slices != 0u) {
        uint before = uint(bitCount(cell.slices & ((1u << slice) - 1u)));
        list.first = cell.first + (before == 0u ? uint(bitCount(cell.slices)) : light_entries[cell.first + before - 1u]);
        // Pixels without surface run along with their neighbours, and their slice may have no list.
        bool listed = (cell.slices >> slice & 1u) != 0u;
        list.count = listed ? cell.first + light_entries[cell.first + before] - list.first : 0u;
    }
    list.count += list.everywhere;
    list.first -= list.everywhere; // an index from the list's own start on
    return list;
}

// SwiftShader reads for invocations that have left the loop too: past the end stands light 0.
uint listed_light(LightList list, uint i) {
    return light_entries[i < list.everywhere ? i : i < list.count ? list.first + i : 0u];
}
#endif
