// Forward shading: a surface, and what one light adds to it. Fresnel of each light at V·H (model=full), or
// at N·V (nv).
#ifndef PRELIGHT_FORWARD_LIGHT_GLSL
#define PRELIGHT_FORWARD_LIGHT_GLSL
#include "shared/lighting.glsl"
#include "shared/surface.glsl"

layout(constant_id = CONSTANT_MODEL) const int model = MODEL_FULL;
layout(constant_id = CONSTANT_COUNT_PAIRS) const bool count_pairs = false;
layout(constant_id = CONSTANT_LIGHT_OUTPUT) const int light_output = LIGHT_OUTPUT_LIGHT;

// Two counters a row of pixels, so that no sum overflows 32 bits: evaluated, contributing.
layout(set = SET_INPUTS, binding = INPUT_PAIR_COUNTERS, std430) buffer PairCounters { uint pair_counters[]; };

struct ForwardSurface {
    vec3 base;
    Reflectance reflectance;
    LitPoint point;
    float schlick_nv;
};

ForwardSurface forward_surface() {
    ForwardSurface s;
    s.base = base_colour().rgb;
    vec2 factors = metallic_roughness();
    s.reflectance = reflectance(s.base, factors.x);
    s.point = lit_point(true, in_world, shading_normal(), to_viewer(in_world), max(factors.y, 0.089), gl_FragCoord.xy);
    s.schlick_nv = schlick_weight(s.point.nv);
    return s;
}

vec3 forward_light(ForwardSurface s, LightData light, out bool contributes) {
    Lamp lamp = lamp_of(light);
    LightTerms terms = light_terms(lamp, s.point);
    contributes = terms.contributes;
    return reflected(lamp, terms, s.reflectance, model == MODEL_FULL ? schlick_weight(terms.vh) : s.schlick_nv);
}

void count_lights(uint evaluated, uint contributing) {
    if (!count_pairs)
        return;
    int row = 2 * int(gl_FragCoord.y);
    atomicAdd(pair_counters[row], evaluated);
    atomicAdd(pair_counters[row + 1], contributing);
}
#endif
