#version 460
#extension GL_GOOGLE_include_directive : require
// Which of its coarse cell's lights each tile has, a bit a light. A workgroup is a coarse cell and one subgroup, so
// that each light is loaded once: by one invocation, which hands it to the others. An invocation has `tiles` tiles.
#include "shared/light_cells.glsl"
#include "shared/light_share.glsl"
#include "shared/shared_bounds.glsl"

layout(constant_id = CONSTANT_LIST_LANES) const int lanes = 8;
layout(local_size_x_id = CONSTANT_LIST_LANES) in;
const int tiles = LIST_GROUP / lanes;

LightCell cells[tiles];
Piece pieces[tiles];
uint bits[tiles];
uint counts[tiles];

uvec3 tile_at(int tile) { return cell_at(gl_WorkGroupID, gl_LocalInvocationIndex + uint(tile * lanes)); }
uint index_of(int tile) { return index_in(min(tile_at(tile), lists.cells.xyz - 1u), lists.cells.xyz); }

void main() {
    LightCell coarse = coarse_cells[index_in(gl_WorkGroupID, lists.coarse.xyz)];
    for (int t = 0; t < tiles; ++t) {
        cells[t] = light_cells[index_of(t)];
        if (!all(lessThan(tile_at(t), lists.cells.xyz)))
            cells[t].depths = 0u;
        pieces[t] = cell_piece(min(tile_at(t), lists.cells.xyz - 1u), cells[t], 0u, false);
        counts[t] = 0u;
    }
    bool fits = coarse.first != lists.lights.x;
    uint words = fits ? (coarse.count + 31u) / 32u : 0u;
    uint batch = min(min(uint(lanes), gl_SubgroupSize), 32u), word = 0u;
    do { // loops that are left at their end: see light_list.comp
        uint begin = 0u, all = min(32u, coarse.count - word * 32u);
        for (int t = 0; t < tiles; ++t)
            bits[t] = 0u;
        do {
            SharedBounds own = load_bounds(coarse, word * 32u + begin);
            uint some = min(batch, all - begin), lane = 0u;
            do {
                SharedBounds light = shared_bounds(own, lane);
                for (int t = 0; t < tiles; ++t)
                    bits[t] |= reaches(light, cells[t], pieces[t]) ? 1u << (begin + lane) : 0u;
            } while (++lane < some);
            begin += batch;
        } while (begin < all);
        for (int t = 0; t < tiles; ++t) {
            uint tile = gl_LocalInvocationIndex + uint(t * lanes);
            if (words > 0u)
                light_entries[coarse.first + coarse.count + tile * words + word] = bits[t];
            counts[t] += words > 0u ? uint(bitCount(bits[t])) : 0u;
        }
    } while (++word < words);
    for (int t = 0; t < tiles; ++t)
        if (all(lessThan(tile_at(t), lists.cells.xyz)))
            light_cells[index_of(t)].count = fits ? counts[t] : coarse.count;
}
