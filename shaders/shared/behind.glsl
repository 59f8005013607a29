// What lies behind transmissive surfaces: the opaque picture, sharp and ever more blurred (behind_level.comp).
#ifndef PRELIGHT_BEHIND_GLSL
#define PRELIGHT_BEHIND_GLSL
#include "shared/behind.h"
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_BEHIND_LAST_LEVEL) const int behind_last = 0;
layout(set = SET_INPUTS, binding = INPUT_BEHIND) uniform ONE_SAMPLE_IMAGE behind_image;

vec3 behind_texel(ivec2 corner, ivec2 texel) { return one_sample_read(behind_image, corner + texel).rgb; }

// Bilinear; past the picture's edges its outermost texels go on. `place`: pixels.
vec3 behind_of_level(vec2 place, int level) {
    ivec2 size = ivec2(raster.size.xy), corner = behind_corner(size, level), last = behind_size(size, level) - 1;
    vec2 at = place * exp2(-float(level)) - 0.5, whole = floor(at), part = at - whole;
    ivec2 low = clamp(ivec2(whole), ivec2(0), last), high = clamp(ivec2(whole) + 1, ivec2(0), last);
    vec3 top = mix(behind_texel(corner, low), behind_texel(corner, ivec2(high.x, low.y)), part.x);
    vec3 bottom = mix(behind_texel(corner, ivec2(low.x, high.y)), behind_texel(corner, high), part.x);
    return mix(top, bottom, part.y);
}

// Exposed radiance at a place of the picture, pixels from its top left; `level` between two is their mean.
vec3 behind(vec2 place, float level) {
    place = clamp(place, vec2(0.0), raster.size.xy);
    float above = clamp(level, 0.0, float(behind_last));
    int lower = int(above);
    return mix(behind_of_level(place, lower), behind_of_level(place, min(lower + 1, behind_last)), above - float(lower));
}
#endif
