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
#define LIGHT_IMAGE ONE_SAMPLE_IMAGE_BITS
#else
#define LIGHT_IMAGE ONE_SAMPLE_IMAGE
#endif
layout(set = SET_INPUTS, binding = INPUT_DIFFUSE_LIGHT) uniform LIGHT_IMAGE diffuse_light;
layout(set = SET_INPUTS, binding = INPUT_SPECULAR_LIGHT) uniform LIGHT_IMAGE specular_light;
#ifdef SAMPLE_LIGHT
#include "shared/edge_samples.glsl"
layout(set = SET_INPUTS, binding = INPUT_EDGE_FLAGS) uniform ONE_SAMPLE_IMAGE_BITS edges;
layout(set = SET_INPUTS, binding = INPUT_SAMPLE_DEPTH) uniform texture2DMS sample_depth;
layout(set = SET_INPUTS, binding = INPUT_SAMPLE_DIFFUSE) uniform LIGHT_IMAGE sample_diffuse;
layout(set = SET_INPUTS, binding = INPUT_SAMPLE_SPECULAR) uniform LIGHT_IMAGE sample_specular;
#endif

#ifdef SURFACE_IDS
#include "shared/inferred_light.glsl"
#endif

struct StoredLight {
    vec4 first, second;
};

#ifdef LIGHT_PAIR
StoredLight fetched(LIGHT_IMAGE diffuse, LIGHT_IMAGE specular, ivec2 texel) {
    uvec4 bits = one_sample_read(diffuse, texel);
    return StoredLight(half_floats(bits.xy), half_floats(bits.zw));
}
#elif defined(LIGHT_BITS)  // graph::Pass::sample_bits()
StoredLight fetched(LIGHT_IMAGE diffuse, LIGHT_IMAGE specular, ivec2 texel) {
    return StoredLight(half_floats(one_sample_read(diffuse, texel).rg), half_floats(one_sample_read(specular, texel).rg));
}
#else
StoredLight fetched(LIGHT_IMAGE diffuse, LIGHT_IMAGE specular, ivec2 texel) {
    return StoredLight(one_sample_read(diffuse, texel), one_sample_read(specular, texel));
}
#endif

// What the light buffer holds for a pixel.
struct LightTexels {
    vec4 diffuse;   // rgb: Σ diffuse light; a: its weighted grazing term
    vec4 specular;  // rgb: Σ specular light; a: its weighted grazing term
    float weight;   // Σ N·L att, what channel 4 is divided by (equation 8.5.6)
};

LightTexels unpacked(StoredLight texels) {
    // Blending may have gone past the largest half float.
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

#ifdef SAMPLE_LIGHT
layout(constant_id = CONSTANT_POST_DEPTH_COVERAGE) const bool post_depth_coverage = false; // is gl_SampleMaskIn

// The samples that the fragment covers and that nothing nearer covers: there its own plane has the depth that is stored.
// gl_SampleMaskIn is what it covers before the depth test; what stands before it there would lend it its light.
uint owned_samples(ivec2 pixel, vec2 slope) {
    if (post_depth_coverage)
        return uint(gl_SampleMaskIn[0]);
    float most = 0.002 * (abs(slope.x) + abs(slope.y)) + 1e-6 * gl_FragCoord.z; // rounding
    uint covered = uint(gl_SampleMaskIn[0]), owned = 0u;
    for (int i = 0; i < samples; ++i) {
        float own = gl_FragCoord.z + dot(slope, place_of_sample(i) - 0.5);
        owned |= abs(texelFetch(sample_depth, pixel, i).r - own) <= most ? 1u << i : 0u;
    }
    return bitCount(covered) == 1 || (owned & covered) == 0u ? covered : owned & covered;
}

// Where its light lies.
ivec2 texel_of_sample(uvec4 edge, int i) { return edge_texel(first_slot(edge) + surface_of(edge.r, i)); }

// An edge pixel's surfaces have their own light in the sample light buffer. A fragment sees that of the first sample
// that it owns, for its samples share a surface; or where every sample has its own, the mean of them. With both buffers
// in one image it fetches once: a software device runs both sides of an `if` for all pixels.
LightTexels read_light() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 slope = vec2(0.0); // device depth is linear over a triangle
    if (!post_depth_coverage)
        slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
    uvec4 edge = one_sample_read(edges, pixel);
    bool apart = has_slots(edge) && gl_SampleMaskIn[0] != 0; // pixels beside the triangle run along
    if (!every_sample) {
        ivec2 texel = pixel;
        if (apart)
            texel = texel_of_sample(edge, findLSB(owned_samples(pixel, slope)));
        StoredLight stored = fetched(diffuse_light, specular_light, edge_first_row > 0 ? texel : pixel);
        if (edge_first_row == 0 && apart)
            stored = fetched(sample_diffuse, sample_specular, texel);
        return unpacked(stored);
    }
    LightTexels light = unpacked(fetched(diffuse_light, specular_light, pixel));
    if (apart) {
        uint owned = owned_samples(pixel, slope);
        light = LightTexels(vec4(0.0), vec4(0.0), 0.0);
        float share = 1.0 / float(max(bitCount(owned), 1));
        for (int i = 0; i < samples; ++i) {
            float own = float(owned >> i & 1u) * share;
            LightTexels one = unpacked(fetched(sample_diffuse, sample_specular, texel_of_sample(edge, i)));
            light = LightTexels(light.diffuse + own * one.diffuse, light.specular + own * one.specular,
                                light.weight + own * one.weight);
        }
    }
    return light;
}
#elif defined(SURFACE_IDS)
LightTexels read_light(Taps taps) {
    LightTexels light = LightTexels(vec4(0.0), vec4(0.0), 0.0);
    for (int i = 0; i < 4; ++i) {
        LightTexels one = unpacked(fetched(diffuse_light, specular_light, taps.at[i]));
        float share = taps.share[i];
        light = LightTexels(light.diffuse + share * one.diffuse, light.specular + share * one.specular,
                            light.weight + share * one.weight);
    }
    return light;
}
#else
LightTexels read_light() { return unpacked(fetched(diffuse_light, specular_light, ivec2(gl_FragCoord.xy))); }
#endif

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
