// The sample light buffer: light of edge pixels' samples, gathered by sample_edges.comp. Its texels lie in tiles of 8 × 8,
// each of one block of the picture's 8 × 8 pixels; in a tile a pixel's samples follow each other along a row.
#ifndef PRELIGHT_EDGE_SAMPLES_GLSL
#define PRELIGHT_EDGE_SAMPLES_GLSL
#include "shared/light_lists.h"
#include "shared/samples.glsl"

layout(constant_id = CONSTANT_EDGE_TILES) const uint edge_tiles = 1u; // that the buffer has room for
layout(constant_id = CONSTANT_EDGE_ROW) const uint edge_row = 1u;     // of them along x

const uint NO_EDGE_PIXEL = 0xffffffffu; // what fills up a tile

uint edge_pixels_of_tile() { return uint(LIT_BLOCK * LIT_BLOCK) / uint(samples); }

// Texel `slot` of a tile, counted along its rows.
ivec2 edge_texel(uint tile, uint slot) {
    return ivec2(tile % edge_row, tile / edge_row) * LIT_BLOCK + ivec2(slot % LIT_BLOCK, slot / LIT_BLOCK);
}

// Of an edge pixel's first sample; the others follow along x. `number`: of the pixel in the buffer.
ivec2 edge_texel(uint number) {
    uint per_tile = edge_pixels_of_tile();
    return edge_texel(number / per_tile, number % per_tile * uint(samples));
}
#endif
