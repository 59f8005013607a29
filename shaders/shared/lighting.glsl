// One light on one surface point: falloff, the terms that a light buffer sums, and what a material
// makes of them.
#ifndef PRELIGHT_LIGHTING_GLSL
#define PRELIGHT_LIGHTING_GLSL
#include "shared/frame.glsl"
#include "shared/shininess.glsl"
#include "shared/reflectance.glsl"

layout(constant_id = CONSTANT_SHADING) const int shading = SHADING_GGX;
layout(constant_id = CONSTANT_SEED_FALLOFF) const bool seed_falloff = false;
layout(constant_id = CONSTANT_SPECULAR_STEP_GATE) const bool specular_step_gate = false;
layout(constant_id = CONSTANT_REFLECTION_VECTOR) const bool reflection_vector = false;
layout(constant_id = CONSTANT_SPECULAR_WAY) const int specular_way = SPECULAR_STORED;

// KHR_lights_punctual: clamp(1 − (d/range)⁴, 0, 1) / max(d, 0.01 m)², times the cone. `to_light` is
// not normalised; for a directional light it is a unit vector and the result is 1.
float attenuation(LightData light, vec3 to_light, out vec3 l) {
    float d2 = dot(to_light, to_light);
    float inverse = inversesqrt(max(d2, 1e-12));
    l = to_light * inverse;
    float x2 = d2 * light.colour.w * light.colour.w;
    float window = clamp(1.0 - x2 * x2, 0.0, 1.0);
    float falloff = window / max(d2, 1e-4);
    if (seed_falloff) {
        float linear = clamp(1.0 - sqrt(x2), 0.0, 1.0);
        float quadratic = clamp(1.0 - x2, 0.0, 1.0);
        falloff = light.cone.z < 0.5 ? falloff : light.cone.z < 1.5 ? linear : quadratic;
    }
    float cone = clamp(-dot(light.axis.xyz, l) * light.cone.x + light.cone.y, 0.0, 1.0);
    return falloff * cone * cone;
}

// glTF 2.0, appendix B: Trowbridge-Reitz D times separable Smith visibility V. nl, nv > 0. The
// cancellation in f stays below 1 % of D, for alpha is at least 0.089².
float specular_ggx(float alpha, float nh, float nl, float nv) {
    float a2 = alpha * alpha;
    float f = nh * nh * (a2 - 1.0) + 1.0;
    float d = a2 / (3.14159265 * f * f);
    float v = 1.0 / ((nl + sqrt(a2 + (1.0 - a2) * nl * nl)) * (nv + sqrt(a2 + (1.0 - a2) * nv * nv)));
    return d * v;
}

// Half vector; zero where light and viewer are exactly opposite.
vec3 half_vector(vec3 l, vec3 v) {
    vec3 sum = l + v;
    return sum * inversesqrt(max(dot(sum, sum), 1e-20));
}

// [phong]: (N·H)^n or (R·V)^n without the gate.
float specular_phong(float exponent, vec3 n, vec3 l, vec3 v) {
    float base = reflection_vector ? dot(reflect(-l, n), v) : dot(n, half_vector(l, v));
    return pow(clamp(base, 1e-6, 1.0), exponent);
}

// The weight of 1 − F0 in Schlick's reflectance.
float schlick_weight(float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    return m * m * m * m * m;
}

// What one light sends to a surface point, before the material's colours come in.
struct LightTerms {
    vec3 diffuse;       // N·L att colour
    vec3 specular;      // [ggx] N·L att colour D V; [phong] gate att colour (N·H)^n
    vec3 h;             // unit half vector
    bool contributes;   // attenuation and N·L are above zero
};

// `surface` false: nothing is there to be lit, all terms are 0. `roughness` is at least 0.089.
LightTerms light_terms(LightData light, bool surface, vec3 world, vec3 n, vec3 v, float roughness) {
    vec3 l;
    float att = attenuation(light, light.position.xyz - world * light.position.w, l);
    float nl = surface ? clamp(dot(n, l), 0.0, 1.0) : 0.0;
    vec3 h = half_vector(l, v);
    float lobe;
    if (shading == SHADING_GGX) {
        float alpha = roughness * roughness;
        lobe = nl > 0.0 ? nl * specular_ggx(alpha, clamp(dot(n, h), 0.0, 1.0), nl, max(dot(n, v), 1e-4)) : 0.0;
    } else {
        float gate = specular_step_gate ? (nl > 0.0 ? 1.0 : 0.0) : nl;
        // Only way 1 knows the material here; the others raise to its exponent in the material pass.
        float own = specular_way == SPECULAR_STORED ? shininess(roughness) : 1.0;
        lobe = gate > 0.0 ? gate * specular_phong(light.axis.w * own, n, l, v) : 0.0;
    }
    vec3 light_in = light.colour.rgb * att;
    return LightTerms(light_in * nl, light_in * lobe, h, att > 0.0 && nl > 0.0);
}

// What a surface sends on to the viewer; `schlick` weighs 1 − F0 ([ggx] only).
vec3 reflected(LightTerms terms, Reflectance r, float schlick) {
    if (shading == SHADING_PHONG)
        return r.diffuse * terms.diffuse + r.f0 * terms.specular;
    vec3 fresnel = r.f0 + (1.0 - r.f0) * schlick;
    return r.diffuse / 3.14159265 * (1.0 - fresnel) * terms.diffuse + fresnel * terms.specular;
}
#endif
