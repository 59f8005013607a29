// How bright the light on a picture's surfaces is, and what a fixed-point light buffer makes of it: the scale that its
// codes are multiples of, one for each of the two sums.
#ifndef PRELIGHT_LIGHT_SCALE_H
#define PRELIGHT_LIGHT_SCALE_H
#include "shared/interop.h"
SHARED_BEGIN

#define LIGHT_SAMPLES 57600      // pixels that are asked at least, where there are so many
#define LIGHT_SAMPLE_STEPS 4     // and at least one of so many squared
#define LIGHT_SAMPLE_GROUP 8     // side of a workgroup, in such pixels
#define LIGHT_BIN_OCTAVE 16      // bins for each doubling
#define LIGHT_BIN_LOWEST (-16)   // exponent of the lowest bin's lower end
#define LIGHT_BINS 512
#define LIGHT_SCALE_GROUP 64
#define LIGHT_CLIP_GROUP 8

// Before the bins of the diffuse and of the specular sum.
struct LightHistogram {
    uint surfaces;      // pixels with light
    uint contributions; // light × pixel pairs that contribute to them
    uint brightest_diffuse, brightest_specular;  // the bits of a float
};

// What the host reads after a frame.
struct LightScaleResult {
    float scale[2];     // of the diffuse and the specular sum
    uint clipped;       // pixels with a channel at the largest value
    uint unused;
};

#ifdef __cplusplus
// Every how many pixels along an axis one is asked.
inline uint32_t light_sample_step(uint32_t width, uint32_t height) {
    uint32_t step = 1;
    while (step < LIGHT_SAMPLE_STEPS && uint64_t(width) * height > uint64_t(LIGHT_SAMPLES) * step * step)
        ++step;
    return step;
}
#endif

SHARED_END
#endif
