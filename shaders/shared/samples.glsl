// Several samples a pixel, and where they lie.
#ifndef PRELIGHT_SAMPLES_GLSL
#define PRELIGHT_SAMPLES_GLSL
#include "shared/bindings.h"

layout(constant_id = CONSTANT_SAMPLES) const int samples = 1;

// From the pixel's upper left corner: Vulkan's standard sample locations.
vec2 place_of_sample(int i) {
    if (samples == 2)
        return i == 0 ? vec2(0.75) : vec2(0.25);
    return i == 0 ? vec2(0.375, 0.125) : i == 1 ? vec2(0.875, 0.375) : i == 2 ? vec2(0.125, 0.625) : vec2(0.625, 0.875);
}
#endif
