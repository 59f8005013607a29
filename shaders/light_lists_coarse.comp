#version 460
#extension GL_GOOGLE_include_directive : require
// variants: GRID_CELLS
// Coarse cells: the depths of their tiles, and no light yet.
#include "shared/light_cells.glsl"

layout(local_size_x = LIST_GROUP) in;

void main() {
    uint coarse = gl_GlobalInvocationID.x;
    if (coarse >= lists.coarse.w)
        return;
    uint start = mask_start(coarse);
    uint summary = summary_words(), words = light_words();
    for (uint i = 0u; i < summary + words; ++i)
        light_masks[start + i] = 0u;
    LightCell range = LightCell(3e38, 0.0, 0u, 0u, 0u, 0u);
#ifndef GRID_CELLS
    uvec3 group = uvec3(coarse % lists.coarse.x, coarse / lists.coarse.x, 0u);
    for (uint i = 0u; i < LIST_GROUP; ++i) {
        uvec3 at = cell_at(group, i);
        if (any(greaterThanEqual(at, lists.cells.xyz)))
            continue;
        LightCell cell = light_cells[index_in(min(at, lists.cells.xyz - 1u), lists.cells.xyz)];
        if (cell.nearest <= cell.farthest) {
            range.nearest = min(range.nearest, cell.nearest);
            range.farthest = max(range.farthest, cell.farthest);
            range.depths |= cell.depths;
        }
    }
#endif
    coarse_cells[coarse] = range;
}
