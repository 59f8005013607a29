// Images of the frame as passes read them: by pixel, and by sample where SAMPLES is defined, for images that hold
// several samples a pixel. Whoever declares one, or fetches from one, does it through these.
#ifndef PRELIGHT_PIXEL_READS_GLSL
#define PRELIGHT_PIXEL_READS_GLSL
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/frame.glsl"
#include "shared/raster.h"

layout(set = SET_INPUTS, binding = INPUT_RASTER, std140) uniform RasterBlock { RasterConstants raster; };

#ifdef SAMPLES
#define PIXEL_IMAGE texture2DMS
#define PIXEL_IMAGE_BITS utexture2DMS
int pixel_sample = 0;  // the one that pixel_read() reads
#define pixel_read(image, pixel) texelFetch(image, pixel, pixel_sample)
#else
#define PIXEL_IMAGE texture2D
#define PIXEL_IMAGE_BITS utexture2D  // unsigned integers
#define pixel_read(image, pixel) texelFetch(image, pixel, 0)
#endif

ivec2 last_pixel() { return ivec2(raster.size.xy) - 1; }

// Clip space x and y of a place in pixels from the left and upper edge.
vec2 clip_of(vec2 place) { return place * raster.size.zw * 2.0 - 1.0; }

// Metres across a pixel at this view depth.
float pixel_metres(float z) { return 2.0 * length(frame.ray_up.xyz) * raster.size.w * mix(1.0, z, frame.forward.w); }
#endif
