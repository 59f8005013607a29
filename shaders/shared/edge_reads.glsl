// Finding the surfaces of edge pixels again, for passes that light them.
#ifndef PRELIGHT_EDGE_READS_GLSL
#define PRELIGHT_EDGE_READS_GLSL
#include "shared/edge_samples.glsl"
#include "shared/pixel_reads.glsl"

layout(set = SET_INPUTS, binding = INPUT_EDGE_PIXELS, std430) readonly buffer EdgeBlock { uint edge_pixels[]; };

ivec2 edge_at = ivec2(0); // the pixel that edge_pixel() found last

// The pixel of a slot, whose block lies at `block`; (-1, -1): none. From then on pixel_read() reads the first sample of
// the surface, and its place and depth are the mean of its samples.
ivec2 edge_pixel(uint slot, uvec2 block) {
    uint filled = edge_pixels[slot];
    bool none = filled == NO_SURFACE;
    uvec2 pixel = block * LIT_BLOCK + uvec2(filled % LIT_BLOCK, filled / LIT_BLOCK % LIT_BLOCK);
    shared_samples = none ? 1u : filled / BLOCK_PIXELS;
    pixel_sample = findLSB(shared_samples);
    edge_at = none ? ivec2(0) : ivec2(pixel);
    return none ? ivec2(-1) : edge_at;
}

#ifndef STORAGE_TARGET // draws: a texel of the sample light buffer is a fragment
layout(set = SET_INPUTS, binding = INPUT_LIT_BLOCKS, std430) readonly buffer TileBlock { LitBlocks tiles; uint tile_blocks[]; };

ivec2 edge_pixel_of_fragment() {
    uvec2 texel = uvec2(gl_FragCoord.xy);
    uint tile = texel.y / EDGE_TILE_ROWS * edge_row + texel.x / LIT_BLOCK, block = tile_blocks[min(tile, edge_tiles - 1u)];
    uint across = (uint(raster.size.x) + LIT_BLOCK - 1u) / LIT_BLOCK;
    return edge_pixel(tile * TILE_SLOTS + texel.y % EDGE_TILE_ROWS * LIT_BLOCK + texel.x % LIT_BLOCK,
                      uvec2(block % across, block / across));
}
#endif
#endif
