// What a light pass knows of a pixel before its first light, and how it counts light × pixel pairs.
#ifndef PRELIGHT_LIT_PIXEL_GLSL
#define PRELIGHT_LIT_PIXEL_GLSL
#include "shared/gbuffer.glsl"
#if defined(SAMPLES) && defined(SHADOWS)
#define SHADOWS_ELSEWHERE
#endif
#include "shared/lighting.glsl"

layout(constant_id = CONSTANT_MODEL) const int model = MODEL_WEIGHTED;
layout(constant_id = CONSTANT_COUNT_PAIRS) const bool count_pairs = false;

// Two counters a row of pixels, so that no sum overflows 32 bits: evaluated, contributing.
layout(set = SET_INPUTS, binding = INPUT_PAIR_COUNTERS, std430) buffer PairCounters { uint pair_counters[]; };

#ifdef DEFERRED_TARGET
layout(set = SET_INPUTS, binding = INPUT_MATERIAL) uniform PIXEL_IMAGE material_buffer;  // RT2
layout(set = SET_INPUTS, binding = INPUT_ALBEDO) uniform PIXEL_IMAGE albedo_buffer;      // RT3
#endif

#ifdef SHADOWS_ELSEWHERE // of the pixel's one surface
layout(set = SET_INPUTS, binding = INPUT_PIXEL_DEPTH) uniform ONE_SAMPLE_IMAGE pixel_depth;
layout(set = SET_INPUTS, binding = INPUT_PIXEL_NORMAL) uniform ONE_SAMPLE_IMAGE pixel_normal;
#endif

struct LitPixel {
    LitPoint point;
#ifdef DEFERRED_TARGET
    bool takes_light; // not unlit
    Reflectance reflects;
#endif
};

LitPixel read_pixel(ivec2 pixel) {
    LitPixel p;
    vec3 world;
    bool surface = read_position(pixel, world);
    p.point = lit_point(surface, world, read_normal(pixel), to_viewer(world), max(read_roughness(pixel), 0.089),
                        vec2(pixel) + 0.5);
#ifdef SHADOWS_ELSEWHERE
    if (shadows_at_pixel) {
        p.point.shadow_world = position_of(vec2(pixel) + 0.5, one_sample_read(pixel_depth, pixel).r);
        p.point.shadow_n = stored_normal(one_sample_read(pixel_normal, pixel));
    }
#endif
#ifdef DEFERRED_TARGET
    vec4 albedo = pixel_read(albedo_buffer, pixel);
    p.takes_light = stored_reflectance(pixel_read(material_buffer, pixel), albedo, p.reflects);
#ifdef SHADOWS
    if (gbuffer_layout == GBUFFER_KILLZONE2) {
        p.point.sun = uint(frame.sun.x);
        p.point.sunlit = albedo.a;
    }
#endif
#endif
    return p;
}

void count_lights(ivec2 pixel, uint evaluated, uint contributing) {
    if (!count_pairs)
        return;
    atomicAdd(pair_counters[2 * pixel.y], evaluated);
    if (contributing > 0u)
        atomicAdd(pair_counters[2 * pixel.y + 1], contributing);
}
#endif
