// Images of the frame, and the raster of the pass that reads or writes them by pixel.
#ifndef PRELIGHT_PIXEL_READS_GLSL
#define PRELIGHT_PIXEL_READS_GLSL
#include "shared/frame.glsl"
#include "shared/pixel_images.glsl"
#include "shared/raster.h"

// A uniform buffer: a software device loads from a storage buffer lane by lane, although all lanes want the same.
layout(set = SET_INPUTS, binding = INPUT_RASTER, std140) uniform RasterBlock { RasterConstants raster; };

ivec2 last_pixel() { return ivec2(raster.size.xy) - 1; }

// Where a pixel's sample lies, pixels: that of pixel_read(), the mean of those that share a surface, or the only one.
vec2 place_of(ivec2 pixel) {
#ifdef SAMPLES
    if (shared_samples == 0u)
        return vec2(pixel) + place_of_sample(pixel_sample);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < samples; ++i)
        sum += (shared_samples >> i & 1u) != 0u ? place_of_sample(i) : vec2(0.0);
    return vec2(pixel) + sum / float(bitCount(shared_samples));
#else
    return vec2(pixel) + 0.5;
#endif
}

// Clip space x and y of a place in pixels from the left and upper edge.
vec2 clip_of(vec2 place) { return place * raster.size.zw * 2.0 - 1.0; }

// Metres across a pixel at this view depth.
float pixel_metres(float z) { return 2.0 * length(frame.ray_up.xyz) * raster.size.w * mix(1.0, z, frame.forward.w); }
#endif
