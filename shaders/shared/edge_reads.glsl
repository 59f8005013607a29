// Finding the samples of edge pixels again, for passes that light them.
#ifndef PRELIGHT_EDGE_READS_GLSL
#define PRELIGHT_EDGE_READS_GLSL
#include "shared/edge_samples.glsl"
#include "shared/pixel_reads.glsl"

layout(set = SET_INPUTS, binding = INPUT_EDGE_PIXELS, std430) readonly buffer EdgeBlock { uint edge_pixels[]; };

ivec2 edge_at = ivec2(0); // the pixel that edge_pixel() found last

// The pixel of a slot of a tile, whose block lies at `block`, and its sample in pixel_sample; (-1, -1): none.
ivec2 edge_pixel(uint tile, uint slot, uvec2 block) {
    uint within = edge_pixels[tile * edge_pixels_of_tile() + slot / uint(samples)];
    pixel_sample = int(slot) % samples;
    bool none = within == NO_EDGE_PIXEL;
    uvec2 pixel = block * LIT_BLOCK + uvec2(within % LIT_BLOCK, within / LIT_BLOCK);
    edge_at = none ? ivec2(0) : ivec2(pixel);
    return none ? ivec2(-1) : edge_at;
}

#ifndef STORAGE_TARGET // draws: a texel of the sample light buffer is a fragment
layout(set = SET_INPUTS, binding = INPUT_LIT_BLOCKS, std430) readonly buffer TileBlock { LitBlocks tiles; uint tile_blocks[]; };

ivec2 edge_pixel_of_fragment() {
    uvec2 texel = uvec2(gl_FragCoord.xy);
    uint tile = texel.y / LIT_BLOCK * edge_row + texel.x / LIT_BLOCK, block = tile_blocks[min(tile, edge_tiles - 1u)];
    uint across = (uint(raster.size.x) + LIT_BLOCK - 1u) / LIT_BLOCK;
    return edge_pixel(tile, texel.y % LIT_BLOCK * LIT_BLOCK + texel.x % LIT_BLOCK, uvec2(block % across, block / across));
}
#endif
#endif
