#version 460
#extension GL_GOOGLE_include_directive : require
// variants: DEFERRED_TARGET, SHADOWS, STENCIL_ROUGHNESS
// never: DEFERRED_TARGET STENCIL_ROUGHNESS
// How bright the lights' sums are: a histogram over some of the picture's surfaces, for light_scale.comp. A workgroup is
// 8 × 8 pixels, one out of each `pixel_step` squared; it tests 64 lights at a time against the box around them. Lights are
// added in the frame's order and counts do not depend on who comes first, so two runs give the same bytes.
#define NO_TARGET
#include "shared/light_sums.glsl"
#include "shared/light_bounds.glsl"
#include "shared/light_scale.h"

layout(constant_id = CONSTANT_PACKED_LIGHT) const bool packed_light = false;
layout(constant_id = CONSTANT_LIGHT_SAMPLE_STEP) const uint pixel_step = 4u;
layout(local_size_x = LIGHT_SAMPLE_GROUP, local_size_y = LIGHT_SAMPLE_GROUP) in;
layout(push_constant) uniform PeakBlock { uint light_count; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_HISTOGRAM, std430) buffer HistogramBlock { LightHistogram histogram; uint bins[]; };

shared int low[3], high[3]; // of the surfaces, as integers in the floats' order
shared uint wanted[2];      // a bit for each of 64 lights

int ordered(float value) {
    int bits = floatBitsToInt(value);
    return bits ^ ((bits >> 31) & 0x7fffffff);
}
float from_ordered(int bits) { return intBitsToFloat(bits ^ ((bits >> 31) & 0x7fffffff)); }

#ifdef DEFERRED_TARGET  // whose surfaces have been drawn small: what they send without lights is in the sum
layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform PIXEL_IMAGE own_light;
#endif

// Another pixel of each block, so that no line of a regular picture is missed as a whole.
ivec2 sampled_pixel() {
#ifdef DEFERRED_TARGET  // drawn small already
    return ivec2(gl_GlobalInvocationID.xy);
#endif
    uvec2 block = gl_GlobalInvocationID.xy;
    uint turn = (block.x * 7u + block.y * 11u) % (pixel_step * pixel_step);
    return ivec2(block * pixel_step + uvec2(turn % pixel_step, turn / pixel_step));
}

bool reaches(LightData light, vec3 box_low, vec3 box_high) {
    LightBounds b = bounds_of(light);
    vec3 gap = max(max(box_low - b.centre, b.centre - box_high), vec3(0.0));
    return light.inverse_range <= 0.0 || (light.kind & LIGHT_DIRECTIONAL) != 0u || !(dot(gap, gap) > b.radius * b.radius);
}

uint bin_of(float value) {
    return uint(clamp((log2(max(value, 1e-12)) - LIGHT_BIN_LOWEST) * LIGHT_BIN_OCTAVE, 0.0, LIGHT_BINS - 1.0));
}

float largest(vec3 v) { return max(v.r, max(v.g, v.b)); }

void main() {
    uint me = gl_LocalInvocationIndex;
    if (me < 3u) {
        low[me] = ordered(3e38);
        high[me] = ordered(-3e38);
    }
    if (me < 2u)
        wanted[me] = 0u;
    barrier();
    ivec2 pixel = sampled_pixel(), last = last_pixel();
    LitPixel p = read_pixel(min(pixel, last));
    p.point.surface = p.point.surface && all(lessThanEqual(pixel, last));
    for (int axis = 0; axis < 3; ++axis)
        if (p.point.surface) {
            atomicMin(low[axis], ordered(p.point.world[axis]));
            atomicMax(high[axis], ordered(p.point.world[axis]));
        }
    barrier();
    vec3 box_low = vec3(from_ordered(low[0]), from_ordered(low[1]), from_ordered(low[2]));
    vec3 box_high = vec3(from_ordered(high[0]), from_ordered(high[1]), from_ordered(high[2]));

    LightSums sums = no_light();
    uint contributing = 0u;
    bool any_surface = box_low.x <= box_high.x;
    for (uint begin = 0u; begin < light_count && any_surface; begin += 64u) {
        uint index = min(begin + me, light_count - 1u);
        if (begin + me < light_count && reaches(lights[light_order[index]], box_low, box_high))
            atomicOr(wanted[me >> 5], 1u << (me & 31u));
        barrier();
        uint words[2] = uint[](wanted[0], wanted[1]);
        barrier();
        if (me < 2u)
            wanted[me] = 0u;
        for (uint word = 0u; word < 2u; ++word)
            for (uint bits = words[word]; bits != 0u; bits &= bits - 1u) {
                uint light = light_order[min(begin + word * 32u + uint(findLSB(bits)), light_count - 1u)];
                contributing += add_light(sums, p, light_source(lights[light])) ? 1u : 0u;
            }
        barrier();
    }
    if (!p.point.surface)
        return;
#ifdef DEFERRED_TARGET
    float diffuse = largest(sums.light + pixel_read(own_light, pixel).rgb), specular = 0.0;
#else
    if (ambient_as_light)
        add_ambient(sums);
    // Alphas of pairs and the fifth channel are weighted means of what is counted: never larger.
    float diffuse = specular_way == SPECULAR_LUV ? luminance(sums.diffuse.rgb) : largest(sums.diffuse.rgb);
    float specular = packed_light ? luminance(sums.specular.rgb) : largest(sums.specular.rgb);
#endif
    if (!(max(diffuse, specular) > 0.0))
        return;
    atomicAdd(histogram.surfaces, 1u);
    atomicAdd(histogram.contributions, contributing);
    atomicAdd(bins[bin_of(diffuse)], 1u);
    atomicAdd(bins[LIGHT_BINS + bin_of(specular)], 1u);
    atomicMax(histogram.brightest_diffuse, floatBitsToUint(diffuse));
    atomicMax(histogram.brightest_specular, floatBitsToUint(specular));
}
