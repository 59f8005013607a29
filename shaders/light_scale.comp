#version 460
#extension GL_GOOGLE_include_directive : require
// The scale of a fixed-point light buffer, for each of its sums: of all that end a bin of light_peaks.comp's histogram the
// one with the least squared error, which is what brighter pixels lose and what each light's rounding costs. The
// frame's constants get it, and the histogram is empty again.
#include "shared/bindings.h"
#include "shared/frame.h"
#include "shared/light_scale.h"

layout(constant_id = CONSTANT_LIGHT_CODES) const float codes = 255.0;
layout(constant_id = CONSTANT_LIGHT_MOST) const float most = 32.0; // what more light than that adds, no picture shows
layout(constant_id = CONSTANT_LIGHTS_BLENDED) const bool blended = false;
layout(local_size_x = LIGHT_SCALE_GROUP) in;
layout(set = SET_INPUTS, binding = INPUT_LIGHT_HISTOGRAM, std430) buffer HistogramBlock { LightHistogram histogram; uint bins[]; };
layout(set = SET_INPUTS, binding = INPUT_LIGHT_SCALE, std430) buffer ResultBlock { LightScaleResult result; };
layout(set = SET_INPUTS, binding = INPUT_FRAME_CONSTANTS, std430) buffer ConstantsBlock { FrameConstants constants; };

shared float errors[LIGHT_BINS];

float bin_end(float bin) { return exp2(LIGHT_BIN_LOWEST + bin / LIGHT_BIN_OCTAVE); }

// A few more than the brightest of the pixels that were asked: the others may be a little brighter.
float candidate(uint bin, float brightest) {
    return min(min(bin_end(float(bin) + 1.0), brightest * 1.03), most);
}

float error_of(uint sum, float scale, float roundings) {
    float error = roundings / 12.0 * scale * scale / (codes * codes);
    for (uint b = 0u; b < LIGHT_BINS; ++b) {
        float lost = max(min(bin_end(float(b) + 0.5), most) - scale, 0.0);
        error += float(bins[sum * LIGHT_BINS + b]) * lost * lost;
    }
    return error;
}

void main() {
    uint me = gl_LocalInvocationID.x;
    float roundings = float(blended ? histogram.contributions : histogram.surfaces);
    for (uint sum = 0u; sum < 2u; ++sum) {
        float brightest = uintBitsToFloat(sum == 0u ? histogram.brightest_diffuse : histogram.brightest_specular);
        for (uint b = me; b < LIGHT_BINS; b += LIGHT_SCALE_GROUP)
            errors[b] = error_of(sum, candidate(b, brightest), roundings);
        barrier();
        if (me == 0u) {
            uint best = 0u;
            for (uint b = 1u; b < LIGHT_BINS; ++b)
                best = errors[b] < errors[best] ? b : best;
            float scale = brightest > 0.0 ? candidate(best, brightest) : 1.0;
            result.scale[sum] = scale;
            if (sum == 0u)
                constants.light_buffer.x = scale;
            else
                constants.light_buffer.z = scale;
        }
        barrier();
    }
    for (uint b = me; b < 2u * LIGHT_BINS; b += LIGHT_SCALE_GROUP)
        bins[b] = 0u;
    if (me == 0u)
        histogram = LightHistogram(0u, 0u, 0u, 0u);
}
