// Instead of light: how many lights a pixel evaluates (R) and how many of them contribute (G), for
// --view light-count.
#ifndef PRELIGHT_LIGHT_COUNT_SUMS_GLSL
#define PRELIGHT_LIGHT_COUNT_SUMS_GLSL
#define ONE_TARGET
#include "shared/light_target.glsl"
#include "shared/lit_pixel.glsl"

struct LightSums {
    float evaluated, contributing;
};

LightSums no_light() { return LightSums(0.0, 0.0); }

bool add_light(inout LightSums sums, LitPixel p, LightSource source) {
    bool contributes = light_terms(source, p.point).contributes;
    sums.evaluated += 1.0;
    sums.contributing += contributes ? 1.0 : 0.0;
    return contributes;
}

void add_ambient(inout LightSums sums) {} // is no light × pixel pair

void write_sums(ivec2 pixel, LightSums sums) {
    vec4 counts = vec4(sums.evaluated, sums.contributing, 0.0, 0.0);
#ifdef ADDED
    counts += first_before(pixel);
#endif
    write_first(pixel, counts);
}
#endif
