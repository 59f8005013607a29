// How many blended surfaces lie over the pixels of a frame.
#ifndef PRELIGHT_LAYER_COUNTS_H
#define PRELIGHT_LAYER_COUNTS_H
#include "shared/interop.h"
SHARED_BEGIN

#define LAYER_COUNT_GROUP 8 // side of a workgroup, in blocks
#define LAYER_COUNT_BLOCK 4 // side of the pixels of an invocation

// What the host reads after a frame. Of several samples a pixel each counts.
struct LayerCounts {
    uint most;                   // in a sample
    uint total_low, total_high;  // of all samples, 64 bits
    uint more_low, more_high;    // of them those beyond `exact` in each sample
};

// Push constants.
struct LayerCounting {
    uvec2 size;  // pixels to count
    uint exact;  // layers of a sample that are drawn each by itself
};

SHARED_END
#endif
