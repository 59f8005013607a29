// Push constants of the pass that adds all lights in one loop.
#ifndef PRELIGHT_LIGHT_LOOP_H
#define PRELIGHT_LIGHT_LOOP_H
#include "shared/interop.h"
SHARED_BEGIN

struct LightLoop {
    uint first, end;  // in light_order[]
    uint ambient;     // 1: ambient light is one of the lights
};

SHARED_END
#endif
