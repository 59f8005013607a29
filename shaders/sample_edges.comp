#version 460
#extension GL_GOOGLE_include_directive : require
// variants: WIDE_SLOTS
// Gathers the surfaces of edge pixels, so that they can be lit evenly: those of a block of 8 × 8 pixels fill tiles
// of the sample light buffer, as many as they need. An invocation looks after a block: barriers between those
// of a block cost a software device more than all else here.
#include "shared/edge_samples.glsl"
#include "shared/pixel_reads.glsl"

layout(local_size_x = LIST_GROUP) in;
layout(set = SET_INPUTS, binding = INPUT_EDGES) uniform PIXEL_IMAGE_BITS edges;
// The same image; only texels of edges are written.
#ifdef WIDE_SLOTS
layout(set = SET_INPUTS, binding = INPUT_EDGE_TARGET, rgba32ui) uniform writeonly uimage2D edge_target;
#else
layout(set = SET_INPUTS, binding = INPUT_EDGE_TARGET, r32ui) uniform writeonly uimage2D edge_target;
#endif
layout(set = SET_INPUTS, binding = INPUT_LIT_BLOCKS, std430) buffer TileBlock { LitBlocks tiles; uint tile_blocks[]; };
layout(set = SET_INPUTS, binding = INPUT_EDGE_PIXELS, std430) writeonly buffer PixelBlock { uint edge_pixels[]; };
layout(set = SET_INPUTS, binding = INPUT_EDGE_COUNTS, std430) buffer CountBlock { uint tile_count; }; // needed, for the host

ivec2 pixel_of(ivec2 low, uint i) { return low + ivec2(i % LIT_BLOCK, i / LIT_BLOCK); }

// The samples of surface `s`, as they stand in a slot.
uint samples_of(uint edge, uint s) {
    uint mask = 0u;
    for (int i = 0; i < samples; ++i)
        mask |= surface_of(edge, i) == s ? 1u << i : 0u;
    return mask;
}

void main() {
    ivec2 size = last_pixel() + 1;
    uvec2 blocks = uvec2(size + LIT_BLOCK - 1) / LIT_BLOCK;
    uint block = gl_GlobalInvocationID.x;
    bool there = block < blocks.x * blocks.y;
    ivec2 low = ivec2(block % blocks.x, block / blocks.x) * LIT_BLOCK;
    uvec2 found = uvec2(0u); // a bit a pixel
    uint count = 0u;
    // Loops here are left at their end: see light_list.comp.
    uint i = 0u;
    do {
        ivec2 pixel = pixel_of(low, i);
        bool inside = there && all(lessThan(pixel, size));
        uint surfaces = inside ? surfaces_of(pixel_read(edges, min(pixel, size - 1)).r) : 0u;
        uint bit = surfaces > 0u ? 1u << (i % 32u) : 0u;
        found |= i < 32u ? uvec2(bit, 0u) : uvec2(0u, bit);
        count += surfaces;
    } while (++i < BLOCK_PIXELS);

    uint needed = (count + TILE_SLOTS - 1u) / TILE_SLOTS, first = edge_tiles;
    if (needed > 0u) {
        first = atomicAdd(tiles.dispatch.w, needed);
        atomicMax(tiles.dispatch.y, (min(first + needed, edge_tiles) + LIT_ROW - 1u) / LIT_ROW);
        atomicAdd(tile_count, needed);
    }
    // What does not fit is lit once: its slots lie past the end.
    uint slot = first * TILE_SLOTS, end = edge_tiles * TILE_SLOTS;
    while ((found.x | found.y) != 0u) {
        bool lower = found.x != 0u;
        uint bit = uint(findLSB(lower ? found.x : found.y));
        found = lower ? uvec2(found.x & (found.x - 1u), found.y) : uvec2(0u, found.y & (found.y - 1u));
        uint place = bit + (lower ? 0u : 32u);
        ivec2 pixel = pixel_of(low, place);
        uint edge = pixel_read(edges, pixel).r, surfaces = surfaces_of(edge);
        imageStore(edge_target, pixel, edge_with_slot(edge, min(slot, end)));
        for (uint s = 0u; s < surfaces; ++s, ++slot)
            if (slot < end)
                edge_pixels[slot] = samples_of(edge, s) * BLOCK_PIXELS + place;
    }
    for (uint last = min((first + needed) * TILE_SLOTS, end); slot < last; ++slot)
        edge_pixels[slot] = NO_SURFACE;
    for (uint t = first; t < min(first + needed, edge_tiles); ++t)
        tile_blocks[t] = block;
}
