#version 460
#extension GL_GOOGLE_include_directive : require
// variants: OWN_MATERIAL, LIGHT_BITS|LIGHT_PAIR, ONLY_WEIGHTED, OCCLUSION, DECALS|NO_TEXTURES|LAYER_DECALS, SAMPLE_LIGHT, SAMPLES, SURFACE_IDS, LAYER, SOFT
// only: SAMPLES with DECALS, SAMPLE_LIGHT DECALS with SAMPLES
// never: OWN_MATERIAL ONLY_WEIGHTED, OWN_MATERIAL NO_TEXTURES
// only: OCCLUSION with OWN_MATERIAL, LAYER with SURFACE_IDS, LAYER_DECALS with LAYER, SOFT with LAYER
// never: SURFACE_IDS SAMPLES, SURFACE_IDS SAMPLE_LIGHT, LAYER OCCLUSION, LAYER DECALS, SOFT LAYER_DECALS
// materials: all with OWN_MATERIAL, blinn_phong with ONLY_WEIGHTED
// Stage 3: the object's material from the light buffer. Compiled with each material; with the two standard
// ones as material_blinn_phong.frag (equation 8.5.3) and material_metallic_roughness.frag.
#if defined(ONLY_WEIGHTED) && !defined(LAYER_DECALS)  // model=weighted
#define NO_WORLD
#define NO_NORMAL
#endif
#include "shared/display.glsl"
#include "shared/half_samples.glsl"
#include "shared/light_buffer.glsl"
#include "shared/material_interface.glsl"
#include "shared/shininess.glsl"
#ifdef SOFT
#include "shared/soft.glsl"
#endif

layout(constant_id = CONSTANT_MODEL) const int model = MODEL_WEIGHTED;
layout(constant_id = CONSTANT_MATERIAL_OUTPUT) const int material_output = MATERIAL_OUTPUT_SHADED;
layout(constant_id = CONSTANT_AMBIENT_AS_LIGHT) const bool ambient_as_light = false;
#ifdef OCCLUSION
layout(set = SET_INPUTS, binding = INPUT_OCCLUSION) uniform ONE_SAMPLE_IMAGE visibility_buffer;
#endif
#ifdef SURFACE_IDS
layout(early_fragment_tests) in; // it counts pixels
#endif
layout(location = 0) out vec4 out_colour;

// A material with a shininess of its own raises the lights' sum to it.
vec3 specular_sum(LightTexels texels, float roughness) {
    return shading == SHADING_PHONG ? specular_light_of(texels, shininess(roughness)) : texels.specular.rgb;
}

#ifdef OCCLUSION
#ifdef SURFACE_IDS
float visibility(Taps taps) {
    float sum = 0.0;
    for (int i = 0; i < 4; ++i)
        sum += taps.share[i] * one_sample_read(visibility_buffer, taps.at[i]).r;
    return sum;
}
#else
float visibility() { return one_sample_read(visibility_buffer, ivec2(gl_FragCoord.xy)).r; }
#endif
#endif

Light light_of(LightTexels texels, float open, Point p, Surface s) {
    Light light;
    light.irradiance = texels.diffuse.rgb;
    light.diffuse = light.irradiance / lambert_divisor;
    light.luminance = luminance(light.diffuse);
    light.specular = specular_sum(texels, s.roughness);
    light.ambient = ambient_as_light ? vec3(0.0) : frame.ambient.rgb * s.occlusion;
    light.mirrored = light.ambient;
    light.reflectance = vec2(1.0, 0.0);
    light.openness = 1.0;
    add_environment(light, p, s);
#ifdef OCCLUSION
    occlude(light, p, s, open);
#endif
    light.grazing_diffuse = mean_grazing(texels.diffuse);
    light.grazing_specular = mean_grazing(texels.specular);
#ifndef ONLY_WEIGHTED
    // Equation 8.5.8 suggests it: Fresnel at N·V (nv, mono). [phong] sums no grazing terms.
    if (model != MODEL_WEIGHTED || shading == SHADING_PHONG)
        light.grazing_diffuse = light.grazing_specular = grazing_at_viewer(p, s);
#endif
    return light;
}

// Blended by its alpha; an opaque surface's is 1.
vec4 covering(Surface s, vec3 colour) {
    float alpha = blended_coverage(s);
#ifdef SOFT
    alpha *= share_before_opaque(view_depth(gl_FragCoord.z));
#endif
    return vec4(stored_colour(min(colour, vec3(65504.0))).rgb, in_half_samples ? half_samples_alpha(alpha) : alpha);
}

void main() {
    Point p = point();
    Surface s = surface_under_decals(p);
    if (material_output == MATERIAL_OUTPUT_ALBEDO) {
        out_colour = vec4(s.base, 1.0);
        return;
    }
    if (has(FEATURE_UNLIT)) {
        out_colour = covering(s, s.base * frame.light_buffer.y);
        return;
    }
    float open = 1.0;
#ifdef SURFACE_IDS
    Taps taps = find_taps();
    if (material_output == MATERIAL_OUTPUT_UNMATCHED) {
#ifdef LAYER
        out_colour = vec4(vec3(1.0), taps.unmatched ? 1.0 : 0.0);
#else
        out_colour = vec4(taps.unmatched ? vec3(1.0) : 0.05 + 0.15 * s.base, 1.0);
#endif
        return;
    }
    if (material_output == MATERIAL_OUTPUT_SHADED)
        count_unmatched(taps);
    LightTexels texels = read_light(taps);
#ifdef OCCLUSION
    open = visibility(taps);
#endif
#else
    LightTexels texels = read_light();
#ifdef OCCLUSION
    open = visibility();
#endif
#endif
    if (material_output == MATERIAL_OUTPUT_DIFFUSE_SUM) {
        out_colour = vec4(texels.diffuse.rgb, 1.0);
        return;
    }
    if (material_output == MATERIAL_OUTPUT_SPECULAR_SUM) {
        out_colour = vec4(specular_sum(texels, s.roughness), 1.0);
        return;
    }
    out_colour = covering(s, shade(p, s, light_of(texels, open, p, s)));
}
