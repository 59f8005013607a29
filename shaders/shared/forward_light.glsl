// Forward shading: a surface, and what lights add to it. Fresnel of each light at V·H (model=full), or at N·V
// (nv); a material of its own gets the lights' sums, as the light buffer would hold them.
#ifndef PRELIGHT_FORWARD_LIGHT_GLSL
#define PRELIGHT_FORWARD_LIGHT_GLSL
#include "shared/lighting.glsl"
#include "shared/base_light.glsl"
#include "shared/specular_antialiasing.glsl"
#ifdef TRANSMISSION
#include "shared/transmission.glsl"
#endif
#ifdef SOFT
#include "shared/soft.glsl"
#endif

layout(constant_id = CONSTANT_MODEL) const int model = MODEL_FULL;
layout(constant_id = CONSTANT_COUNT_PAIRS) const bool count_pairs = false;
layout(constant_id = CONSTANT_LIGHT_OUTPUT) const int light_output = LIGHT_OUTPUT_LIGHT;

// Two counters a row of pixels, so that no sum overflows 32 bits: evaluated, contributing.
layout(set = SET_INPUTS, binding = INPUT_PAIR_COUNTERS, std430) buffer PairCounters { uint pair_counters[]; };

struct ForwardSurface {
    Point at;
    Surface surface;
    Reflectance reflectance;
    LitPoint point;
#ifdef TRANSMISSION
    LitPoint back;  // as lamps behind the surface light it
#endif
    float schlick_nv;
};

ForwardSurface forward_surface() {
    ForwardSurface s;
    s.at = point();
    s.surface = surface_under_decals(s.at);
#ifdef SOFT
    s.surface.alpha = blended_coverage(s.surface) * share_before_opaque(dot(in_world, frame.forward.xyz));
#endif
    s.reflectance = reflectance(s.surface.base, s.surface.metallic);
    s.point = lit_point(true, in_world, s.surface.normal, s.at.to_viewer, max(antialiased_roughness(s.at, s.surface), 0.089), gl_FragCoord.xy);
    s.schlick_nv = schlick_weight(s.point.nv);
#ifdef TRANSMISSION
    s.back = lit_through(s.point, antialiased_roughness(s.at, s.surface), gl_FragCoord.xy);
#endif
    return s;
}

#ifdef OWN_MATERIAL
struct ForwardSums {
    vec3 irradiance, specular;
    float grazing_diffuse, grazing_specular;  // weighted by luminance
#ifdef TRANSMISSION
    vec3 through;  // the specular sum of lamps behind the surface
#endif
};
ForwardSums no_lights() {
    return ForwardSums(vec3(0.0), vec3(0.0), 0.0, 0.0
#ifdef TRANSMISSION
                       , vec3(0.0)
#endif
    );
}

void add_light_source(inout ForwardSums sums, ForwardSurface s, LightData light, out bool contributes) {
    LightSource source = light_source(light);
#ifdef TRANSMISSION
    // Of one side: the other's terms are 0.
    bool is_behind = dot(source.position.xyz - in_world * source.position.w, s.point.n) < 0.0;
    LightTerms terms = light_terms(source, is_behind ? s.back : s.point);
    sums.through += is_behind ? source.colour * terms.specular : vec3(0.0);
    terms.diffuse = is_behind ? 0.0 : terms.diffuse;
    terms.specular = is_behind ? 0.0 : terms.specular;
#else
    LightTerms terms = light_terms(source, s.point);
#endif
    contributes = terms.contributes;
    float grazing = schlick_weight(terms.vh);
    sums.irradiance += source.colour * terms.diffuse;
    sums.specular += source.colour * terms.specular;
    sums.grazing_diffuse += source.luminance * terms.diffuse * grazing;
    sums.grazing_specular += source.luminance * terms.specular * grazing;
}

vec3 shade_lights(ForwardSurface s, ForwardSums sums, vec3 ambient, bool with_base) {
    Light light = light_of_ambient_alone(ambient, s.schlick_nv);
    if (with_base)
        add_environment(light, s.at, s.surface);
    light.irradiance = sums.irradiance;
    light.diffuse = sums.irradiance / lambert_divisor;
    light.luminance = luminance(light.diffuse);
    light.specular = sums.specular;
    if (shading == SHADING_GGX && model == MODEL_FULL) { // nv: as light_of_ambient_alone() has it
        light.grazing_diffuse = clamp(sums.grazing_diffuse / max(luminance(sums.irradiance), 1e-12), 0.0, 1.0);
        light.grazing_specular = clamp(sums.grazing_specular / max(luminance(sums.specular), 1e-12), 0.0, 1.0);
    }
#ifdef TRANSMISSION
    light_through = transmittance(body_depth(s.at)) * (sums.through + (with_base ? picture_behind(s.at, s.surface) : vec3(0.0)));
#endif
    return shade(s.at, s.surface, light);
}

// With the base all of it at once; without, what these lights add to a surface without any.
vec3 forward_colour(ForwardSurface s, ForwardSums sums, bool with_base, float limit) {
    if (with_base)
        return has(FEATURE_UNLIT) ? base_light(s.at, s.surface)
                                  : min(shade_lights(s, sums, frame.ambient.rgb * s.surface.occlusion, true), vec3(limit + 32752.0));
    return clamp(shade_lights(s, sums, vec3(0.0), false) - shade_lights(s, no_lights(), vec3(0.0), false), vec3(-limit), vec3(limit));
}
#else
struct ForwardSums {
    vec3 light;
};
ForwardSums no_lights() { return ForwardSums(vec3(0.0)); }

void add_light_source(inout ForwardSums sums, ForwardSurface s, LightData light, out bool contributes) {
    LightSource source = light_source(light);
    LightTerms terms = light_terms(source, s.point);
    contributes = terms.contributes;
    sums.light += reflected(source, terms, s.reflectance, model == MODEL_FULL ? schlick_weight(terms.vh) : s.schlick_nv);
}

vec3 forward_colour(ForwardSurface s, ForwardSums sums, bool with_base, float limit) {
    vec3 colour = min(sums.light, vec3(limit));
    if (with_base)
        colour += min(base_light(s.at, s.surface), vec3(32752.0));
    return colour;
}
#endif

void count_lights(uint evaluated, uint contributing) {
    if (!count_pairs)
        return;
    int row = 2 * int(gl_FragCoord.y);
    atomicAdd(pair_counters[row], evaluated);
    atomicAdd(pair_counters[row + 1], contributing);
}
#endif
