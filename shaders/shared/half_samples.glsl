// transparency=half-samples in what draws surfaces: blended ones as if they were opaque, into samples of their own.
#ifndef PRELIGHT_HALF_SAMPLES_GLSL
#define PRELIGHT_HALF_SAMPLES_GLSL
#include "shared/half_samples.h"
#include "shared/material_interface.glsl"

layout(constant_id = CONSTANT_HALF_SAMPLES) const bool in_half_samples = false;

// By its mask, or because it covers too little.
bool is_left_out(Surface s) {
    return is_masked(s) || (in_half_samples && blended_coverage(s) < HALF_SAMPLES_LEAST_ALPHA);
}
#endif
