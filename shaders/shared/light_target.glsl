// Where a light pass puts a pixel's sums: colour attachments, or storage images of a compute pass.
#ifndef PRELIGHT_LIGHT_TARGET_GLSL
#define PRELIGHT_LIGHT_TARGET_GLSL
#include "shared/pixel_reads.glsl"

#ifdef NO_TARGET  // the sums are looked at and go nowhere
void write_first(ivec2 pixel, vec4 value) {}
void write_second(ivec2 pixel, vec4 value) {}
#elif defined(STORAGE_TARGET)
#ifdef LIGHT_PAIR
#include "shared/light_pair.glsl"
layout(set = SET_INPUTS, binding = INPUT_LIGHT_TARGET) uniform writeonly uimage2D pair_target;
void write_pair(ivec2 pixel, vec4 first, vec4 second) { imageStore(pair_target, pixel, light_pair(first, second)); }
#else
layout(set = SET_INPUTS, binding = INPUT_LIGHT_TARGET) uniform writeonly image2D first_target;
void write_first(ivec2 pixel, vec4 value) { imageStore(first_target, pixel, value); }
#ifndef ONE_TARGET
layout(set = SET_INPUTS, binding = INPUT_SECOND_LIGHT_TARGET) uniform writeonly image2D second_target;
void write_second(ivec2 pixel, vec4 value) { imageStore(second_target, pixel, value); }
#endif
#endif
// What the targets held, for passes that add to it; draws blend instead.
#if defined(ADDED) && defined(LIGHT_PAIR)
layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform ONE_SAMPLE_IMAGE_BITS pair_before;
vec4 first_before(ivec2 pixel) { return half_floats(one_sample_read(pair_before, pixel).xy); }
vec4 second_before(ivec2 pixel) { return half_floats(one_sample_read(pair_before, pixel).zw); }
#elif defined(ADDED) || (defined(DEFERRED_TARGET) && !defined(SAMPLES))
layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform ONE_SAMPLE_IMAGE target_before;
vec4 first_before(ivec2 pixel) { return one_sample_read(target_before, pixel); }
#ifndef ONE_TARGET
layout(set = SET_INPUTS, binding = INPUT_SECOND_BEFORE) uniform ONE_SAMPLE_IMAGE second_target_before;
vec4 second_before(ivec2 pixel) { return one_sample_read(second_target_before, pixel); }
#endif
#endif
#else
layout(location = 0) out vec4 out_first;
void write_first(ivec2 pixel, vec4 value) { out_first = value; }
#ifndef ONE_TARGET
layout(location = 1) out vec4 out_second;
void write_second(ivec2 pixel, vec4 value) { out_second = value; }
#endif
#endif
#endif
