// Instead of light: how many lights a pixel evaluates (R) and how many of them contribute (G), for
// --view light-count.
#ifndef PRELIGHT_LIGHT_COUNT_SUMS_GLSL
#define PRELIGHT_LIGHT_COUNT_SUMS_GLSL
#include "shared/lit_pixel.glsl"

layout(location = 0) out vec4 out_counts;

struct LightSums {
    float evaluated, contributing;
};

LightSums no_light() { return LightSums(0.0, 0.0); }

bool add_light(inout LightSums sums, LitPixel p, LightData light) {
    bool contributes = terms_of(p, light).contributes;
    sums.evaluated += 1.0;
    sums.contributing += contributes ? 1.0 : 0.0;
    return contributes;
}

void add_ambient(inout LightSums sums) {} // is no light × pixel pair

void write_sums(LightSums sums) { out_counts = vec4(sums.evaluated, sums.contributing, 0.0, 0.0); }
#endif
