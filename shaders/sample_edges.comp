#version 460
#extension GL_GOOGLE_include_directive : require
// Gathers the samples of edge pixels, so that they can be lit evenly: those of a block of 8 × 8 pixels fill 8 × 8 texels
// of the sample light buffer, and as many more as they need. A pixel's samples are neighbours in a row.
#include "shared/edge_samples.glsl"
#include "shared/pixel_reads.glsl"

layout(local_size_x = LIT_BLOCK, local_size_y = LIT_BLOCK) in;
layout(set = SET_INPUTS, binding = INPUT_EDGES) uniform PIXEL_IMAGE_BITS edges;
layout(set = SET_INPUTS, binding = INPUT_EDGE_INDEX, r32ui) uniform writeonly uimage2D edge_index;
layout(set = SET_INPUTS, binding = INPUT_LIT_BLOCKS, std430) buffer TileBlock { LitBlocks tiles; uint tile_blocks[]; };
layout(set = SET_INPUTS, binding = INPUT_EDGE_PIXELS, std430) writeonly buffer PixelBlock { uint edge_pixels[]; };
layout(set = SET_INPUTS, binding = INPUT_EDGE_COUNTS, std430) buffer CountBlock { uint edge_counts[]; }; // pixels, tiles
shared uint bits[2];
shared uint first_tile;

void main() {
    uint me = gl_LocalInvocationIndex, per_tile = edge_pixels_of_tile();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool inside = all(lessThanEqual(pixel, last_pixel()));
    bool edge = pixel_read(edges, min(pixel, last_pixel())).r > 0u && inside;
    if (me < 2u)
        bits[me] = 0u;
    barrier();
    if (edge)
        atomicOr(bits[me / 32u], 1u << (me % 32u));
    barrier();
    uint below = bits[me / 32u] & ((1u << (me % 32u)) - 1u);
    uint rank = uint(bitCount(below)) + (me >= 32u ? uint(bitCount(bits[0])) : 0u);
    uint count = uint(bitCount(bits[0]) + bitCount(bits[1]));
    uint needed = (count + per_tile - 1u) / per_tile;
    if (me == 0u) {
        first_tile = needed > 0u ? atomicAdd(tiles.dispatch.w, needed) : 0u;
        if (needed > 0u) {
            atomicMax(tiles.dispatch.y, (min(first_tile + needed, edge_tiles) + LIT_ROW - 1u) / LIT_ROW);
            atomicAdd(edge_counts[0], count);
            atomicAdd(edge_counts[1], needed);
        }
    }
    barrier();
    uint tile = first_tile + rank / per_tile;
    bool fits = edge && tile < edge_tiles; // what does not is lit once
    if (inside)
        imageStore(edge_index, pixel, uvec4(fits ? 1u + first_tile * per_tile + rank : 0u));
    if (fits)
        edge_pixels[first_tile * per_tile + rank] = me;
    uint last = min(needed, max(edge_tiles, first_tile) - first_tile);
    if (me >= count && me < last * per_tile)
        edge_pixels[first_tile * per_tile + me] = NO_EDGE_PIXEL;
    if (me < last)
        tile_blocks[first_tile + me] = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
}
