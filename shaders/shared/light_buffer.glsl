// The light buffer as a material sees it.
#ifndef PRELIGHT_LIGHT_BUFFER_GLSL
#define PRELIGHT_LIGHT_BUFFER_GLSL
#include "shared/frame.glsl"
#include "shared/luv.glsl"
#include "shared/pixel_images.glsl"

layout(constant_id = CONSTANT_PACKED_LIGHT) const bool packed_light = false;
layout(constant_id = CONSTANT_SPECULAR_WAY) const int specular_way = SPECULAR_STORED;
#if defined(LIGHT_BITS) || defined(LIGHT_PAIR)  // half floats as they lie in memory
#include "shared/light_pair.glsl"
#define LIGHT_IMAGE PIXEL_IMAGE_BITS
#else
#define LIGHT_IMAGE PIXEL_IMAGE
#endif
layout(set = SET_INPUTS, binding = INPUT_DIFFUSE_LIGHT) uniform LIGHT_IMAGE diffuse_light;
layout(set = SET_INPUTS, binding = INPUT_SPECULAR_LIGHT) uniform LIGHT_IMAGE specular_light;

struct StoredLight {
    vec4 first, second;
};

StoredLight fetch_light(ivec2 pixel) {
#ifdef LIGHT_PAIR
    uvec4 bits = pixel_read(diffuse_light, pixel);
    return StoredLight(half_floats(bits.xy), half_floats(bits.zw));
#elif defined(LIGHT_BITS)  // graph::Pass::sample_bits()
    return StoredLight(half_floats(pixel_read(diffuse_light, pixel).rg), half_floats(pixel_read(specular_light, pixel).rg));
#else
    return StoredLight(pixel_read(diffuse_light, pixel), pixel_read(specular_light, pixel));
#endif
}

// What the light buffer holds for a pixel.
struct LightTexels {
    vec4 diffuse;   // rgb: Σ diffuse light; a: its weighted grazing term
    vec4 specular;  // rgb: Σ specular light; a: its weighted grazing term
    float weight;   // Σ N·L att, what channel 4 is divided by (equation 8.5.6)
};

LightTexels read_light() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    // Blending may have gone past the largest half float.
    StoredLight texels = fetch_light(pixel);
    vec4 first = texels.first;
    float luv_luminance = first.b;
    if (specular_way == SPECULAR_LUV)
        first.rgb = luv_decode(first.rg) * luv_luminance;
    if (!packed_light) {
        first = min(first * frame.light_buffer.x, vec4(65504.0));
        vec4 second = min(texels.second * frame.light_buffer.z, vec4(65504.0));
        return LightTexels(first, second, 0.0);
    }
    first = min(first * frame.light_buffer.xxxz, vec4(65504.0));
    float weight = luminance(first.rgb);
    if (specular_way == SPECULAR_FIFTH_CHANNEL)
        weight = texels.second.r * frame.light_buffer.x;
    if (specular_way == SPECULAR_LUV)
        weight = luv_luminance * frame.light_buffer.x;
    return LightTexels(vec4(first.rgb, 0.0), vec4(first.aaa, 0.0), min(weight, 65504.0));
}

// 0 stays 0, whatever the exponent.
float raised(float base, float exponent) { return base > 0.0 ? pow(min(base, 1.0), exponent) : 0.0; }

// [phong] The specular sum for a material of its own shininess mn (equation 8.5.4).
vec3 specular_light_of(LightTexels light, float mn) {
    if (specular_way == SPECULAR_STORED)
        return light.specular.rgb; // the exponent was known when the lights were summed
    float channel4 = light.specular.r;
    if (specular_way == SPECULAR_BENT)
        return vec3(raised(channel4, mn)); // equation 8.5.7
    return vec3(light.weight > 0.0 ? raised(channel4 / light.weight, mn) * light.weight : 0.0);
}

// Mean (1 − V·H)⁵ of the lights on this pixel, weighted by their luminance; 0 without light.
float mean_grazing(vec4 light) { return clamp(light.a / max(luminance(light.rgb), 1e-12), 0.0, 1.0); }
#endif
