#version 460
#extension GL_GOOGLE_include_directive : require
// Which 8 × 8 blocks of pixels have a light to add, in the order of the screen, and the dispatch that lights them:
// the others cost nothing. And which of the others had one in the frame before, whose light must go.
#include "shared/bindings.h"
#include "shared/light_lists.h"

layout(constant_id = CONSTANT_LIST_TILE_SIZE) const int tile_size = 16;
layout(constant_id = CONSTANT_AMBIENT_TOO) const bool ambient_too = false;
layout(local_size_x = LIST_SCAN_GROUP) in;
layout(push_constant) uniform ListBlock { LightListConstants lists; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_CELLS, std430) readonly buffer CellBlock { LightCell cells[]; };
layout(set = SET_INPUTS, binding = INPUT_LIT_BLOCKS, std430) buffer LitBlock { LitBlocks lit; uint lit_blocks[]; };
layout(set = SET_INPUTS, binding = INPUT_STALE_BLOCKS, std430) buffer StaleBlock { LitBlocks stale; uint stale_blocks[]; };
// A bit a block. An invocation has whole words of them to itself.
layout(set = SET_INPUTS, binding = INPUT_LIT_BEFORE, std430) buffer BeforeBlock { uint lit_before[]; };
shared uvec2 sums[LIST_SCAN_GROUP];

bool is_lit(uint block) {
    uint across = lists.blocks.x, per_tile = uint(tile_size) / LIT_BLOCK;
    uvec2 tile = uvec2(block % across, block / across) / per_tile;
    LightCell cell = cells[tile.y * lists.cells.x + tile.x];
    bool everywhere = ambient_too || lists.lights.x > 0u;
    return cell.nearest <= cell.farthest && (everywhere || cell.count > 0u);
}

LitBlocks dispatch_of(uint total) {
    return LitBlocks(uvec4(LIT_ROW, (total + LIT_ROW - 1u) / LIT_ROW, 1u, total));
}

void main() {
    uint me = gl_LocalInvocationIndex;
    uint all = lists.blocks.x * lists.blocks.y, all_words = (all + 31u) / 32u;
    uint each = (all_words + LIST_SCAN_GROUP - 1u) / LIST_SCAN_GROUP;
    uint begin = min(me * each, all_words), end = min(begin + each, all_words);
    uvec2 count = uvec2(0u); // lit, stale
    for (uint word = begin; word < end; ++word) {
        uint bits = 0u;
        for (uint i = 0u; i < 32u; ++i)
            bits |= word * 32u + i < all && is_lit(min(word * 32u + i, all - 1u)) ? 1u << i : 0u;
        // Until the lists are written, the word holds what was lit and is not in its place.
        uint gone = lit_before[min(word, all_words - 1u)] & ~bits;
        count += uvec2(bitCount(bits), bitCount(gone));
        lit_before[word] = bits;
        stale_blocks[all + word] = gone;
    }
    sums[me] = count;
    barrier();
    uvec2 to = uvec2(0u);
    for (uint i = 0u; i < me; ++i)
        to += sums[i];
    if (me == LIST_SCAN_GROUP - 1u) {
        lit = dispatch_of(to.x + count.x);
        stale = dispatch_of(to.y + count.y);
    }
    for (uint word = begin; word < end; ++word) {
        uint bits = lit_before[min(word, all_words - 1u)];
        while (bits != 0u) {
            lit_blocks[to.x++] = word * 32u + uint(findLSB(bits));
            bits &= bits - 1u;
        }
        bits = stale_blocks[all + min(word, all_words - 1u)];
        while (bits != 0u) {
            stale_blocks[to.y++] = word * 32u + uint(findLSB(bits));
            bits &= bits - 1u;
        }
    }
}
