// Images of the frame as passes read them: by pixel, and by sample where SAMPLES is defined, for images that hold
// several samples a pixel. Whoever declares one, or fetches from one, does it through these.
#ifndef PRELIGHT_PIXEL_IMAGES_GLSL
#define PRELIGHT_PIXEL_IMAGES_GLSL
#extension GL_EXT_samplerless_texture_functions : require

// One sample a pixel, whatever SAMPLES says of the others.
#define ONE_SAMPLE_IMAGE texture2D
#define ONE_SAMPLE_IMAGE_BITS utexture2D  // unsigned integers
#define one_sample_read(image, pixel) texelFetch(image, pixel, 0)

#ifdef SAMPLES
#include "shared/samples.glsl"
#define PIXEL_IMAGE texture2DMS
#define PIXEL_IMAGE_BITS utexture2DMS
int pixel_sample = 0;      // the one that pixel_read() reads
uint shared_samples = 0u;  // samples of one surface, whose mean depth and place are read; 0: those of pixel_sample
#define pixel_read(image, pixel) texelFetch(image, pixel, pixel_sample)
#define EACH_SAMPLE for (pixel_sample = 0; pixel_sample < samples; ++pixel_sample)
#else
#define PIXEL_IMAGE ONE_SAMPLE_IMAGE
#define PIXEL_IMAGE_BITS ONE_SAMPLE_IMAGE_BITS
#define pixel_read(image, pixel) one_sample_read(image, pixel)
#define EACH_SAMPLE
#endif
#endif
