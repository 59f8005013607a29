// Images of the frame as passes read them: by pixel, and by sample where SAMPLES is defined, for images that hold
// several samples a pixel. Whoever declares one, or fetches from one, does it through these.
#ifndef PRELIGHT_PIXEL_IMAGES_GLSL
#define PRELIGHT_PIXEL_IMAGES_GLSL
#extension GL_EXT_samplerless_texture_functions : require

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
#endif
