// The sample light buffer: light of edge pixels' surfaces, gathered by sample_edges.comp. Its texels lie in tiles of 8 × 2,
// each of one block of the picture's 8 × 8 pixels. The samples of a pixel that share a surface share a texel, and a
// pixel's texels follow each other.
#ifndef PRELIGHT_EDGE_SAMPLES_GLSL
#define PRELIGHT_EDGE_SAMPLES_GLSL
#include "shared/light_lists.h"
#include "shared/samples.glsl"

layout(constant_id = CONSTANT_EDGE_TILES) const uint edge_tiles = 1u; // that the buffer has room for
layout(constant_id = CONSTANT_EDGE_ROW) const uint edge_row = 1u;     // of them along x
layout(constant_id = CONSTANT_EDGE_FIRST_ROW) const int edge_first_row = 0; // of texels: above it lies the light buffer

layout(constant_id = CONSTANT_EVERY_EDGE) const bool every_sample = false; // is a surface of its own

const uint TILE_SLOTS = uint(LIT_BLOCK * EDGE_TILE_ROWS), BLOCK_PIXELS = uint(LIT_BLOCK * LIT_BLOCK);

// What is said of a pixel, in one texel, for one fetch. By sample_surfaces.frag: two bits a sample, the number of its
// surface (3, where it has none, is never another's), and above them how many surfaces there are; 0: the pixel is no
// edge. Above these EDGE_BITS, of edges alone, by sample_edges.comp: its first slot in the sample light buffer, whose bits
// that r has no room for are in g, if the image has one.
uint surfaces_of(uint edge) { return edge >> 8 & 7u; }
uint surface_of(uint edge, int i) { return edge >> (2 * i) & 3u; }
uvec4 edge_with_slot(uint edge, uint slot) { return uvec4(edge | slot << EDGE_BITS, slot >> (32 - EDGE_BITS), 0u, 0u); }
uint first_slot(uvec4 texel) { return texel.r >> EDGE_BITS | texel.g << (32 - EDGE_BITS); }

// What fills a slot of the buffer: a pixel of its block, and above six bits the samples that share the surface.
const uint NO_SURFACE = 0xffffffffu;

// Whether an edge pixel's surfaces have light of their own: no, where there was no room.
bool has_slots(uvec4 texel) {
    return texel.r > 0u && first_slot(texel) + surfaces_of(texel.r) <= edge_tiles * TILE_SLOTS;
}

// Slots are counted through all tiles, in a tile along its rows.
ivec2 edge_texel(uint slot) {
    uint tile = slot / TILE_SLOTS, within = slot % TILE_SLOTS;
    return ivec2(tile % edge_row, tile / edge_row) * ivec2(LIT_BLOCK, EDGE_TILE_ROWS) +
           ivec2(within % LIT_BLOCK, edge_first_row + int(within / LIT_BLOCK));
}
#endif
