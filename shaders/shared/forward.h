// Push constants of a forward draw: the lights that it adds.
#ifndef PRELIGHT_FORWARD_H
#define PRELIGHT_FORWARD_H
#include "shared/interop.h"
SHARED_BEGIN

#define FORWARD_MOST_LIGHTS 8

struct ForwardBatch {
    uint count;
    float limit;  // largest value that the draw may add to a target
    uint lights[FORWARD_MOST_LIGHTS];
};

SHARED_END
#endif
