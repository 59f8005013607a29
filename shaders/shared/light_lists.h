// Light lists: what building them and walking them share.
#ifndef PRELIGHT_LIGHT_LISTS_H
#define PRELIGHT_LIGHT_LISTS_H
#include "shared/interop.h"
SHARED_BEGIN

#define LIST_GROUP 64        // invocations of a workgroup: the cells of one coarse cell
#define LIST_COARSE_TILES 8  // side of a coarse cell on the screen, in tiles
#define LIST_COARSE_CELLS 4  // side of a coarse cell in the world, in cells
#define LIST_SLICES 32       // depth slices of a tile: the bits of LightCell::slices
#define LIST_SCAN_GROUP 256
#define LIT_BLOCK 8          // side of the pixels that a workgroup lights
#define EDGE_TILE_ROWS 2     // of LIT_BLOCK texels: a tile of the sample light buffer, for few blocks have many edges
#define EDGE_BITS 11         // of the 32 that say what an edge pixel is; the others are for its first slot
#define LIT_ROW 32           // workgroups of a dispatch along x

// Push constants of every pass that builds or walks lists.
struct LightListConstants {
    uvec4 lights;       // x: lights that are in every list, first in light_order; y: lights with a volume,
                        // after them; z: entries that the buffer holds; w: words of a coarse cell's mask
    uvec4 cells;        // xyz: cells along each axis; w: all of them
    uvec4 blocks;       // xy: blocks of LIT_BLOCK pixels along each axis
    uvec4 coarse;       // xyz: coarse cells along each axis; w: all of them
    vec4 grid_origin;   // xyz: the grid's low corner, world space relative to the camera
    vec4 grid_cell;     // xyz: a cell's size, metres
    uvec4 round;        // the lights of this round: x: where they begin in light_order; y: turns that loops over them may take;
                        // z: number of the round
};

// A tile, a cell of the grid or a coarse cell, and where its lists lie in the entries. Sliced: the entries at
// `first` begin with one end (exclusive) for each slice in use, then the lists follow.
// Sliced, and `slices` 0 with a list of its own: one list for all depths.
// A coarse cell whose tiles have masks: after its `count` lights a bit for each of them, for each of LIST_GROUP
// tiles, in words that belong to one tile.
struct LightCell {
    float nearest, farthest;  // view depth of its surfaces; nearest > farthest: there are none
    uint depths;              // screen: a bit for each depth_bit() of its surfaces
    uint slices;              // slices in use; 0: nothing, or its lists did not fit and `first` is all lights
    uint first, count;
};

// Before the numbers of blocks of pixels, those that have a light or those that had one in the frame before:
// VkDispatchIndirectCommand, and their count.
struct LitBlocks {
    uvec4 dispatch;
};

SHARED_END
#endif
