// Deferred shading [D2]: the lights of a pixel with its material, as they leave for the viewer; added to
// what the geometry pass left in RT0.
#ifndef PRELIGHT_DEFERRED_SUMS_GLSL
#define PRELIGHT_DEFERRED_SUMS_GLSL
#include "shared/lit_pixel.glsl"

layout(location = 0) out vec4 out_light;

struct LightSums {
    vec3 light;
};

LightSums no_light() { return LightSums(vec3(0.0)); }

// True when the light contributes.
bool add_light(inout LightSums sums, LitPixel p, LightData light) {
    LightTerms terms = terms_of(p, light);
    float schlick = schlick_weight(dot(p.v, model == MODEL_FULL ? terms.h : p.n));
    sums.light += p.takes_light ? reflected(terms, p.reflects, schlick) : vec3(0.0);
    return terms.contributes;
}

void write_sums(LightSums sums) {
    vec3 stored = min(sums.light / frame.light_buffer.x, vec3(frame.ambient.w));
    out_light = vec4(stored, luminance(stored) / INTENSITY_RANGE);
}
#endif
