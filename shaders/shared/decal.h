// Push constants of one decal's box.
#ifndef PRELIGHT_DECAL_H
#define PRELIGHT_DECAL_H
#include "shared/interop.h"
SHARED_BEGIN

struct DecalConstants {
    vec4 world_row[3];  // of the 3×4 matrix box → world relative to the camera
    vec4 box_row[3];    // of its inverse
    vec4 fade;          // x, y: scale and offset of cos(angle), 0 where the decal is gone, 1 where it is whole;
                        // w: 1 where the box is seen from inside, else 0
    vec4 opacity;       // of x: colour; y: normal; z: roughness; 0 for what the decal leaves as it is
};

SHARED_END
#endif
