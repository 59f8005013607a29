// Sizes of SMAA's searches, and where smaa_tables.cpp puts the areas that smaa_weights.frag looks up.
#ifndef PRELIGHT_SMAA_H
#define PRELIGHT_SMAA_H
#include "shared/interop.h"
SHARED_BEGIN

// A pixel's edges: towards the pixel at its left, and towards the one above it; the left edge of that upper one, and
// the upper edge of the one at its left.
#define SMAA_LEFT 1
#define SMAA_ABOVE 2
#define SMAA_LEFT_OF_UPPER 4
#define SMAA_ABOVE_BEFORE 8

// Pixels that a search goes each way from a pixel: 16 steps of two along rows and columns, 8 along diagonals.
#define SMAA_REACH 32
#define SMAA_DIAGONAL_REACH 8
#define SMAA_DISTANCES (SMAA_REACH + 1)
#define SMAA_DIAGONAL_DISTANCES (SMAA_DIAGONAL_REACH + 1)

// What crosses a line at one of its ends.
#define SMAA_CROSSING_ABOVE 1  // of a line along a row: an edge that goes up from its end
#define SMAA_CROSSING_BELOW 2
#define SMAA_CROSSING_UPRIGHT 1  // of a diagonal: an edge along a column
#define SMAA_CROSSING_LEVEL 2    // along a row
#define SMAA_CROSSINGS 4

#define SMAA_FIRST_DIAGONAL (SMAA_CROSSINGS * SMAA_CROSSINGS * SMAA_DISTANCES * SMAA_DISTANCES)
#define SMAA_AREAS \
    (SMAA_FIRST_DIAGONAL + SMAA_CROSSINGS * SMAA_CROSSINGS * SMAA_DIAGONAL_DISTANCES * SMAA_DIAGONAL_DISTANCES)

// `before`, `after`: crossings at both ends; `left`, `right`: pixels between the pixel and them.
SHARED_FUNCTION int smaa_area_index(int before, int after, int left, int right) {
    return ((before * SMAA_CROSSINGS + after) * SMAA_DISTANCES + left) * SMAA_DISTANCES + right;
}

SHARED_FUNCTION int smaa_diagonal_index(int before, int after, int left, int right) {
    return SMAA_FIRST_DIAGONAL +
           ((before * SMAA_CROSSINGS + after) * SMAA_DIAGONAL_DISTANCES + left) * SMAA_DIAGONAL_DISTANCES + right;
}

SHARED_END
#endif
