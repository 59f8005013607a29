// Where the levels of what lies behind transmissive surfaces stand in their image (docs/transmission.md). The same text
// is compiled as C++ and as GLSL.
#ifndef PRELIGHT_BEHIND_H
#define PRELIGHT_BEHIND_H
#include "shared/interop.h"
SHARED_BEGIN

// Texels of a level of a picture of `size` pixels: each halves the one before, rounded up.
SHARED_FUNCTION ivec2 behind_size(ivec2 size, int level) {
    return ivec2((size.x + (1 << level) - 1) >> level, (size.y + (1 << level) - 1) >> level);
}

// Its first texel. Level 0 stands in the corner, the others in a row along the picture's longer side: n >> (k − 1) halves
// as sizes do but rounded down, and the one texel more a level makes up for it.
SHARED_FUNCTION ivec2 behind_corner(ivec2 size, int level) {
    bool below = size.x >= size.y;
    int longer = below ? size.x : size.y;
    int along = level < 1 ? 0 : longer - (longer >> (level - 1)) + level - 1;
    int beside = level < 1 ? 0 : below ? size.y : size.x;
    return below ? ivec2(along, beside) : ivec2(beside, along);
}

// The level of one texel.
SHARED_FUNCTION int behind_last_level(ivec2 size) {
    int last = 0;
    while (behind_size(size, last).x > 1 || behind_size(size, last).y > 1)
        ++last;
    return last;
}

SHARED_END
#endif
