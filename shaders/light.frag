#version 460
#extension GL_GOOGLE_include_directive : require
// Stage 2: one light's share of the light buffer [L4], blended ONE/ONE.
// [ggx]: diffuse = Σ N·L att colour, specular = Σ N·L att colour D V; alphas: luminance-weighted
// (1 − V·H)⁵ of each (model=weighted). [phong]: equation 8.5.2. Packed: specular's luminance in alpha.
#include "shared/gbuffer.glsl"
#include "shared/lighting.glsl"

layout(constant_id = CONSTANT_MODEL) const int model = MODEL_WEIGHTED;
layout(constant_id = CONSTANT_COUNT_PAIRS) const bool count_pairs = false;
layout(constant_id = CONSTANT_LIGHT_OUTPUT) const int light_output = LIGHT_OUTPUT_LIGHT;

layout(early_fragment_tests) in;
layout(location = 0) flat in uint in_light;
layout(location = 0) out vec4 out_diffuse;
#ifndef ONE_TARGET
layout(location = 1) out vec4 out_specular;
#endif

// Two counters a row of pixels, so that no sum overflows 32 bits: evaluated, contributing.
layout(set = SET_INPUTS, binding = INPUT_PAIR_COUNTERS, std430) buffer PairCounters { uint pair_counters[]; };

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    LightData light = lights[in_light];
    vec3 world;
    bool surface = read_position(pixel, world);
    vec3 n = read_normal(pixel);
    float roughness = max(read_roughness(pixel), 0.089);

    vec3 v = to_viewer(world);
    LightTerms terms = light_terms(light, surface, world, n, v, roughness);

    if (count_pairs) {
        int row = 2 * pixel.y;
        atomicAdd(pair_counters[row], 1u);
        if (terms.contributes)
            atomicAdd(pair_counters[row + 1], 1u);
    }
#ifdef ONE_TARGET
    if (light_output == LIGHT_OUTPUT_COUNT) {
        out_diffuse = vec4(1.0, terms.contributes ? 1.0 : 0.0, 0.0, 0.0);
        return;
    }
#endif

    float grazing = 0.0;
    if (shading == SHADING_GGX && model == MODEL_WEIGHTED)
        grazing = schlick_weight(dot(v, terms.h));
    vec4 limit = vec4(frame.ambient.w);
    float scale = 1.0 / frame.light_buffer.x;
#ifdef ONE_TARGET
    out_diffuse = min(vec4(terms.diffuse, luminance(terms.specular)) * scale, limit);
#else
    out_diffuse = min(vec4(terms.diffuse, luminance(terms.diffuse) * grazing) * scale, limit);
    out_specular = min(vec4(terms.specular, luminance(terms.specular) * grazing) * scale, limit);
#endif
}
