// What the light buffer holds of a pixel's lights. [ggx]: diffuse = Σ N·L att colour, specular =
// Σ N·L att colour D V; alphas: luminance-weighted (1 − V·H)⁵ of each (model=weighted). [phong]:
// equation 8.5.2, with the material's exponent (specular=stored) or only the light's. Packed: specular's
// luminance in alpha. Where several lights are written at once, they are summed here and rounded once.
#ifndef PRELIGHT_LIGHT_BUFFER_SUMS_GLSL
#define PRELIGHT_LIGHT_BUFFER_SUMS_GLSL
#include "shared/light_target.glsl"
#include "shared/lit_pixel.glsl"
#include "shared/luv.glsl"

layout(constant_id = CONSTANT_AMBIENT_AS_LIGHT) const bool ambient_as_light = false;
layout(constant_id = CONSTANT_LIGHT_STORAGE) const int light_storage = STORAGE_FLOAT16;

struct LightSums {
    vec4 diffuse, specular;
    float fifth;  // channel 5 of equation 8.5.5: Σ N·L att, weighted by luminance as channel 4 is
};

LightSums no_light() { return LightSums(vec4(0.0), vec4(0.0), 0.0); }

// True when the light contributes.
bool add_light(inout LightSums sums, LitPixel p, LightSource source) {
    LightTerms terms = light_terms(source, p.point);
    float grazing = 0.0;
    if (shading == SHADING_GGX && model == MODEL_WEIGHTED)
        grazing = schlick_weight(terms.vh);
    vec4 light = vec4(source.colour, source.luminance * grazing);
    sums.diffuse += light * terms.diffuse;
    sums.specular += light * terms.specular;
    sums.fifth += source.luminance * terms.diffuse;
    return terms.contributes;
}

// Ambient light as a light. [ggx] divides diffuse light by π: a uniform environment of radiance L
// gives irradiance π·L.
void add_ambient(inout LightSums sums) {
    sums.diffuse.rgb += frame.ambient.rgb * (shading == SHADING_GGX ? 3.14159265 : 1.0);
}

// To the nearest float of `bits` stored mantissa bits; those below 2⁻¹⁴ keep more than the target does.
vec3 nearest_float(vec3 value, uvec3 bits) {
    uvec3 dropped = 23u - bits;
    uvec3 half_step = uvec3(1u) << (dropped - 1u);
    return uintBitsToFloat(((floatBitsToUint(max(value, 0.0)) + half_step) >> dropped) << dropped);
}

// Rounded to what the target holds: some drivers cut off instead, and a blended sum of codes is exact.
vec4 stored(vec4 value) {
    vec4 limited = min(value, vec4(frame.ambient.w));
    if (light_storage == STORAGE_UNORM8)
        return floor(min(limited, 1.0) * 255.0 + 0.5) / 255.0;
    if (light_storage == STORAGE_UNORM10)
        return floor(min(limited, 1.0) * vec4(vec3(1023.0), 3.0) + 0.5) / vec4(vec3(1023.0), 3.0);
    if (light_storage == STORAGE_FLOAT11)
        return vec4(min(nearest_float(limited.rgb, uvec3(6u, 6u, 5u)), vec3(64512.0)), 0.0);
    return limited;
}

void write_sums(ivec2 pixel, LightSums sums) {
#if defined(ONE_TARGET) && !defined(STORAGE_TARGET)
    // Chromaticity does not add up: ambient light cannot be blended to it later.
    if (specular_way == SPECULAR_LUV && ambient_as_light)
        add_ambient(sums);
#endif
    float scale = 1.0 / frame.light_buffer.x, specular_scale = 1.0 / frame.light_buffer.z;
    vec4 first = sums.diffuse * scale, second = sums.specular * specular_scale;
#ifdef ONE_TARGET
    first.a = luminance(second.rgb); // channel 4
#else
    if (specular_way == SPECULAR_FIFTH_CHANNEL) {
        first.a = luminance(second.rgb);
        second = vec4(sums.fifth * scale, 0.0, 0.0, 0.0);
    }
#endif
#ifdef ADDED
    vec4 before = first_before(pixel);
    if (specular_way == SPECULAR_LUV)
        before.rgb = luv_decode(before.rg) * before.b;
    first += before;
#ifndef ONE_TARGET
    second += second_before(pixel);
#endif
#endif
    // Chromaticity comes from the sum: that is the mean of the lights' own, weighted by energy.
    if (specular_way == SPECULAR_LUV)
        first.rgb = vec3(luv_encode(first.rgb), luminance(first.rgb));
#ifdef LIGHT_PAIR
    write_pair(pixel, stored(first), stored(second));
#else
    write_first(pixel, stored(first));
#ifndef ONE_TARGET
    write_second(pixel, stored(second));
#endif
#endif
}
#endif
