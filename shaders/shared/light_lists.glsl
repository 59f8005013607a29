// Walking light lists, wherever a pixel's cell comes from: list_size() lights, listed_light(i) each.
#ifndef PRELIGHT_LIGHT_LISTS_GLSL
#define PRELIGHT_LIGHT_LISTS_GLSL
#include "shared/frame.glsl"
#include "shared/sliced.glsl"

#ifndef LIGHT_LISTS_ACCESS
#define LIGHT_LISTS_ACCESS readonly
#endif
layout(push_constant) uniform ListBlock { LightListConstants lists; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_CELLS, std430) LIGHT_LISTS_ACCESS buffer CellBlock { LightCell light_cells[]; };
// All lights of the frame, then lists.
layout(set = SET_INPUTS, binding = INPUT_LIGHT_ENTRIES, std430) LIGHT_LISTS_ACCESS buffer EntryBlock { uint light_entries[]; };

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

// The list of a coarse cell, of which a tile has a mask. Before it stand the lights that are in every list, with
// all bits of their words set but those past their end.
struct MaskedList {
    uint everywhere_words, words;
    uint count, first; // the coarse cell's
    uint mask;         // the tile's first word; 0: all of the coarse cell's lights
};

uint mask_words_of(uint count) { return (count + 31u) / 32u; }

// `light_cells` are the coarse ones.
MaskedList masked_list_of(uvec2 tile) {
    uvec2 coarse = tile / LIST_COARSE_TILES, within = tile % LIST_COARSE_TILES;
    LightCell cell = light_cells[coarse.y * lists.coarse.x + coarse.x];
    uint tile_index = within.y * LIST_COARSE_TILES + within.x;
    bool fits = cell.first != lists.lights.x;
    uint everywhere = mask_words_of(lists.lights.x), own = mask_words_of(cell.count);
    return MaskedList(everywhere, everywhere + own, cell.count, cell.first,
                      fits ? cell.first + cell.count + tile_index * own : 0u);
}

uint mask_word(MaskedList list, uint word) {
    bool everywhere = word < list.everywhere_words;
    uint own = word - list.everywhere_words;
    uint left = everywhere ? lists.lights.x - word * 32u : list.count - own * 32u;
    bool stored = !everywhere && word < list.words && list.mask != 0u;
    uint bits = light_entries[stored ? list.mask + own : 0u];
    return word >= list.words ? 0u : stored ? bits : left >= 32u ? 0xffffffffu : (1u << left) - 1u;
}

// `index`: of a bit, counted from the first word.
uint masked_light(MaskedList list, uint index) {
    uint own = list.everywhere_words * 32u;
    return light_entries[index < own ? index : list.first + (index - own)];
}
#endif
