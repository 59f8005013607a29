#version 460
#extension GL_GOOGLE_include_directive : require
// The tiles of the sample light buffer that hold samples, an instance each.
#include "shared/edge_samples.glsl"

layout(set = SET_INPUTS, binding = INPUT_LIT_BLOCKS, std430) readonly buffer TileBlock { LitBlocks tiles; uint tile_blocks[]; };

void main() {
    uint tile = uint(gl_InstanceIndex), corner = uint(gl_VertexIndex);
    bool there = tile < min(tiles.dispatch.w, edge_tiles);
    vec2 within = vec2(corner == 1u || corner == 2u || corner == 4u, corner == 2u || corner == 4u || corner == 5u);
    vec2 size = vec2(edge_row, edge_tiles / edge_row);
    vec2 place = (vec2(tile % edge_row, tile / edge_row) + within) / size;
    gl_Position = there ? vec4(place * 2.0 - 1.0, 0.0, 1.0) : vec4(-2.0, -2.0, 0.0, 1.0);
}
