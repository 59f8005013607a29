#version 460
#extension GL_GOOGLE_include_directive : require
// Forward shading of up to eight lights, which come as push constants [M2] [Z2]. Fresnel of each
// light at V·H (model=full), or at N·V (nv). Depth test EQUAL: nothing here discards.
#include "shared/forward.h"
#include "shared/lighting.glsl"
#include "shared/surface.glsl"

layout(constant_id = CONSTANT_MODEL) const int model = MODEL_FULL;
layout(constant_id = CONSTANT_COUNT_PAIRS) const bool count_pairs = false;
layout(constant_id = CONSTANT_LIGHT_OUTPUT) const int light_output = LIGHT_OUTPUT_LIGHT;
layout(constant_id = CONSTANT_FORWARD_BASE) const bool with_base = false; // ambient and emissive too

layout(early_fragment_tests) in;
layout(push_constant) uniform BatchBlock { ForwardBatch batch; };
layout(location = 0) out vec4 out_colour;

// Two counters a row of pixels, so that no sum overflows 32 bits: evaluated, contributing.
layout(set = SET_INPUTS, binding = INPUT_PAIR_COUNTERS, std430) buffer PairCounters { uint pair_counters[]; };

vec3 reflected(LightTerms terms, Reflectance r, float schlick) {
    if (shading == SHADING_PHONG)
        return r.diffuse * terms.diffuse + r.f0 * terms.specular;
    vec3 fresnel = r.f0 + (1.0 - r.f0) * schlick;
    return r.diffuse / 3.14159265 * (1.0 - fresnel) * terms.diffuse + fresnel * terms.specular;
}

void main() {
    vec3 base = base_colour().rgb;
    vec2 surface = metallic_roughness();
    Reflectance r = reflectance(base, surface.x);
    float roughness = max(surface.y, 0.089);
    vec3 n = shading_normal();
    vec3 v = to_viewer(in_world);
    float schlick_nv = schlick_weight(dot(n, v));

    vec3 sum = vec3(0.0);
    uint contributing = 0u;
    for (uint i = 0u; i < batch.count; ++i) {
        LightTerms terms = light_terms(lights[batch.lights[i]], true, in_world, n, v, roughness);
        sum += reflected(terms, r, model == MODEL_FULL ? schlick_weight(dot(v, terms.h)) : schlick_nv);
        contributing += terms.contributes ? 1u : 0u;
    }
    if (count_pairs) {
        int row = 2 * int(gl_FragCoord.y);
        atomicAdd(pair_counters[row], batch.count);
        atomicAdd(pair_counters[row + 1], contributing);
    }
    if (light_output == LIGHT_OUTPUT_COUNT) {
        out_colour = vec4(float(batch.count), float(contributing), 0.0, 0.0);
        return;
    }
    vec3 colour = min(sum, vec3(batch.limit));
    if (with_base)
        colour += min(base_light(base), vec3(32752.0));
    out_colour = vec4(colour, with_base ? 1.0 : 0.0);
}
