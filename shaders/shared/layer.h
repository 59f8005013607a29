// Push constants of a blended object's draw in inferred lighting.
#ifndef PRELIGHT_LAYER_H
#define PRELIGHT_LAYER_H
#include "shared/interop.h"
SHARED_BEGIN

// The texels of the light's resolution that are the object's: those with (x & 1) + 2 (y & 1) = slot.
struct LayerConstants {
    uint slot;  // 1 … 3
};

SHARED_END
#endif
