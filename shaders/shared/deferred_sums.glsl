// Deferred shading: the lights of a pixel with its material, as they leave for the viewer; added to
// what the geometry pass left in RT0.
#ifndef PRELIGHT_DEFERRED_SUMS_GLSL
#define PRELIGHT_DEFERRED_SUMS_GLSL
#define ONE_TARGET
#include "shared/light_target.glsl"
#include "shared/lit_pixel.glsl"
#ifdef SAMPLES
#include "shared/edge_reads.glsl"
bool first_round = true; // of lights; what the geometry pass left in RT0 comes with it
#ifndef ADDED
layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform PIXEL_IMAGE own_light; // RT0, of samples
#endif
#endif

struct LightSums {
    vec3 light;
};

LightSums no_light() { return LightSums(vec3(0.0)); }

// True when the light contributes.
bool add_light(inout LightSums sums, LitPixel p, LightSource source) {
    LightTerms terms = light_terms(source, p.point);
    float schlick = schlick_weight(model == MODEL_FULL ? terms.vh : p.point.nv);
    sums.light += p.takes_light ? reflected(source, terms, p.reflects, schlick) : vec3(0.0);
    return terms.contributes;
}

void add_ambient(inout LightSums sums) {} // the geometry pass left it in RT0

void write_sums(ivec2 pixel, LightSums sums) {
    vec3 stored = min(sums.light / frame.light_buffer.x, vec3(frame.ambient.w));
    vec4 light = vec4(stored, luminance(stored) / INTENSITY_RANGE);
#if defined(ADDED) || (defined(STORAGE_TARGET) && !defined(SAMPLES))
    light += first_before(pixel);
#elif defined(SAMPLES)
    light += first_round ? pixel_read(own_light, edge_at) : vec4(0.0);
#endif
    write_first(pixel, light);
}
#endif
