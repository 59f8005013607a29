#version 460
#extension GL_GOOGLE_include_directive : require
// Which 8 × 8 blocks of pixels have a light to add, in the order of the screen, and the dispatch that lights them:
// the others cost nothing.
#include "shared/bindings.h"
#include "shared/light_lists.h"

layout(constant_id = CONSTANT_LIST_TILE_SIZE) const int tile_size = 16;
layout(constant_id = CONSTANT_AMBIENT_TOO) const bool ambient_too = false;
layout(local_size_x = LIST_SCAN_GROUP) in;
layout(push_constant) uniform ListBlock { LightListConstants lists; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_CELLS, std430) readonly buffer CellBlock { LightCell cells[]; };
layout(set = SET_INPUTS, binding = INPUT_LIT_BLOCKS, std430) buffer LitBlock { LitBlocks lit; uint lit_blocks[]; };
shared uint sums[LIST_SCAN_GROUP];

bool is_lit(uint block) {
    uint across = lists.blocks.x, per_tile = uint(tile_size) / LIT_BLOCK;
    uvec2 tile = uvec2(block % across, block / across) / per_tile;
    LightCell cell = cells[tile.y * lists.cells.x + tile.x];
    bool everywhere = ambient_too || lists.lights.x > 0u;
    return cell.nearest <= cell.farthest && (everywhere || cell.count > 0u);
}

void main() {
    uint me = gl_LocalInvocationIndex;
    uint all = lists.blocks.x * lists.blocks.y;
    uint each = (all + LIST_SCAN_GROUP - 1u) / LIST_SCAN_GROUP;
    uint begin = min(me * each, all), end = min(begin + each, all);
    uint count = 0u;
    for (uint i = begin; i < end; ++i)
        count += is_lit(min(i, all - 1u)) ? 1u : 0u;
    sums[me] = count;
    barrier();
    uint to = 0u;
    for (uint i = 0u; i < me; ++i)
        to += sums[i];
    if (me == LIST_SCAN_GROUP - 1u) {
        uint total = to + count;
        lit.dispatch = uvec4(LIT_ROW, (total + LIT_ROW - 1u) / LIT_ROW, 1u, total);
    }
    for (uint i = begin; i < end; ++i)
        if (is_lit(min(i, all - 1u))) {
            lit_blocks[to] = i;
            ++to;
        }
}
