// What a pass knows of the images that it reads or writes by pixel: graph::Pass::raster().
#ifndef PRELIGHT_RASTER_H
#define PRELIGHT_RASTER_H
#include "shared/interop.h"
SHARED_BEGIN

struct RasterConstants {
    vec4 size;  // width, height, 1/width, 1/height in pixels
};

SHARED_END
#endif
