// The nearest layers of blended surfaces of each sample: bits of their depths, the nearest first, 0 where there is none.
// Reversed depth: of positive floats the nearer is the greater, and so are its bits.
#ifndef PRELIGHT_K_BUFFER_GLSL
#define PRELIGHT_K_BUFFER_GLSL
#include "shared/pixel_reads.glsl"
#include "shared/samples.glsl"

#ifndef K_BUFFER_ACCESS
#define K_BUFFER_ACCESS readonly
#endif
layout(constant_id = CONSTANT_K_BUFFER_SLOTS) const uint slots_of_sample = 4u;
layout(set = SET_INPUTS, binding = INPUT_K_BUFFER, std430) K_BUFFER_ACCESS buffer SlotBlock { uint k_buffer[]; };

// Of this invocation's sample; the shader runs once a sample.
uint first_slot() {
    uvec2 pixel = uvec2(min(ivec2(gl_FragCoord.xy), last_pixel()));
    return ((pixel.y * uint(raster.size.x) + pixel.x) * uint(samples) + uint(gl_SampleID)) * slots_of_sample;
}
#endif
