#version 460
#extension GL_GOOGLE_include_directive : require
// Which of its coarse cell's lights each tile has, a bit a light. One invocation a tile; all invocations of a
// workgroup walk the same lights, so that each loads another one and hands it to its neighbours.
#include "shared/light_cells.glsl"
#include "shared/light_share.glsl"
#include "shared/shared_bounds.glsl"

layout(local_size_x = LIST_GROUP) in;

void main() {
    uvec3 at = cell_at(gl_WorkGroupID, gl_LocalInvocationIndex);
    bool inside = all(lessThan(at, lists.cells.xyz));
    at = min(at, lists.cells.xyz - 1u);
    LightCell coarse = coarse_cells[index_in(gl_WorkGroupID, lists.coarse.xyz)];
    uint index = index_in(at, lists.cells.xyz);
    LightCell cell = light_cells[index];
    if (!inside)
        cell.depths = 0u;
    Piece piece = cell_piece(at, cell, 0u);
    bool fits = coarse.first != lists.lights.x;
    uint words = fits ? (coarse.count + 31u) / 32u : 0u;
    uint to = coarse.first + coarse.count + gl_LocalInvocationIndex * words;
    uint batch = min(gl_SubgroupSize, 32u);
    uint word = 0u, count = 0u;
    do { // loops that are left at their end: see light_list.comp
        uint bits = 0u, begin = 0u;
        uint all = min(32u, coarse.count - word * 32u);
        do {
            SharedBounds own = load_bounds(coarse, word * 32u + begin);
            uint some = min(batch, all - begin), lane = 0u;
            do
                bits |= reaches(own, lane, cell, piece) ? 1u << (begin + lane) : 0u;
            while (++lane < some);
            begin += batch;
        } while (begin < all);
        if (words > 0u)
            light_entries[to + word] = bits;
        count += words > 0u ? uint(bitCount(bits)) : 0u;
    } while (++word < words);
    if (inside)
        light_cells[index].count = fits ? count : coarse.count;
}
