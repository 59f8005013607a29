// transparency=half-samples: which of four samples a pixel shows what is opaque, and which the nearest blended surface.
// The same text is compiled as C++ and as GLSL.
#ifndef PRELIGHT_HALF_SAMPLES_H
#define PRELIGHT_HALF_SAMPLES_H
#include "shared/interop.h"
SHARED_BEGIN

// Of Vulkan's standard locations 1 and 2 have their mean at the pixel's centre, as 0 and 3 have, which stay opaque.
#define HALF_SAMPLES_COUNT 4
#define HALF_SAMPLES_BLENDED 0x6u

// What covers less is left out there, or the clear corners of a puff of smoke would hide what is behind them.
#define HALF_SAMPLES_LEAST_ALPHA 0.0625f

// The sample that lies in the same half of the pixel, upper or lower, and shows the other kind of surface.
#define HALF_SAMPLES_OTHER(i) ((i) ^ 1)

// Alpha of a sample that shows a blended surface, as the picture holds it until it is resolved: negative, so that the
// sample is told from one where what is opaque was in front. No half float with a sign is nearer to 0.
SHARED_FUNCTION float half_samples_alpha(float alpha) { return -max(alpha, 6.103515625e-5f); }

SHARED_END
#endif
