#version 460
#extension GL_GOOGLE_include_directive : require
// variants: LIGHT_PAIR|STENCIL_ROUGHNESS|SAMPLES
// A buffer drawn so that a person can read it; of several samples a pixel, one of them.
#include "shared/display.glsl"
#include "shared/gbuffer.glsl"
#include "shared/luv.glsl"

layout(constant_id = CONSTANT_VIEW) const int view = VIEW_DEPTH;
#ifdef SAMPLES
layout(constant_id = CONSTANT_VIEW_SAMPLE) const int view_sample = 0;
#endif
layout(location = 0) out vec4 out_colour;
#ifdef LIGHT_PAIR
#include "shared/edge_samples.glsl"
#include "shared/light_pair.glsl"
layout(set = SET_INPUTS, binding = INPUT_MATERIAL) uniform PIXEL_IMAGE_BITS pair_buffer;
#endif

// Black, blue, cyan, green, yellow, red, white at 0, 1, 4, 16, 64, 256, 1,024 lights.
vec3 heat(float count) {
    const vec3 stops[7] = vec3[](vec3(0), vec3(0, 0, 1), vec3(0, 1, 1), vec3(0, 1, 0), vec3(1, 1, 0), vec3(1, 0, 0), vec3(1));
    float x = count < 1.0 ? count : 1.0 + log2(count) * 0.5;
    vec3 colour = stops[0];
    for (int i = 0; i < 6; ++i)
        colour = mix(colour, stops[i + 1], clamp(x - float(i), 0.0, 1.0));
    return colour;
}

// A colour wheel: red moves right, yellow-green down, cyan left, violet up; black stands still, full
// colour is 63 pixels and more, half of it 7.
vec3 wheel(vec2 pixels) {
    float turn = atan(pixels.y, pixels.x) / 6.2831853;
    vec3 hue = clamp(abs(fract(turn + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return hue * clamp(log2(1.0 + length(pixels)) / 6.0, 0.0, 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef SAMPLES
    pixel_sample = view_sample;
#endif
    // Of the inputs, INPUT_NORMAL holds the buffer that is looked at.
#ifdef LIGHT_PAIR
    uvec4 bits = pixel_read(pair_buffer, pixel);
    vec4 value = half_floats(view == VIEW_SECOND_LIGHT ? bits.zw : bits.xy);
#else
    vec4 value = pixel_read(normal_buffer, pixel);
#endif
    vec3 world;
    bool surface = read_position(pixel, world);
    vec3 colour;
    if (view == VIEW_DEPTH) {
        // White at the camera, halved at each doubling of 1 + distance / 10 m.
        float z = dot(world, frame.forward.xyz);
        colour = vec3(surface ? 1.0 / (1.0 + z / 10.0) : 0.0);
    } else if (view == VIEW_NORMAL) {
        colour = surface ? read_normal(pixel) * 0.5 + 0.5 : vec3(0.0);
    } else if (view == VIEW_ROUGHNESS) {
        colour = vec3(surface ? read_roughness(pixel) : 0.0);
    } else if (view == VIEW_LIGHT || view == VIEW_SECOND_LIGHT) {
        // As a white diffuse surface would show it.
        colour = srgb_encode(tonemap_pbr_neutral(value.rgb * frame.light_buffer.x / 3.14159265));
    } else if (view == VIEW_SPECULAR_LIGHT) {
        colour = srgb_encode(tonemap_pbr_neutral(value.rgb * frame.light_buffer.z / 3.14159265));
    } else if (view == VIEW_LIGHT_ALPHA) {
        colour = srgb_encode(tonemap_pbr_neutral(value.aaa * frame.light_buffer.z / 3.14159265));
    } else if (view == VIEW_LIGHT_LUV) {
        vec3 light = luv_decode(value.rg) * value.b;
        colour = srgb_encode(tonemap_pbr_neutral(light * frame.light_buffer.x / 3.14159265));
    } else if (view == VIEW_ALBEDO) {
        colour = srgb_encode(gbuffer_layout == GBUFFER_KILLZONE2 ? root_decode(value.rgb) : value.rgb);
    } else if (view == VIEW_MOTION) {
        vec2 pixels = stored_motion(value);
        colour = surface && pixels != vec2(0.0) ? wheel(pixels) : vec3(0.0);
    } else if (view == VIEW_SPECULAR) {
        Reflectance r;
        bool takes_light = stored_reflectance(gbuffer_layout == GBUFFER_WIDE ? vec4(0.0) : value, value, r);
        colour = surface && takes_light ? srgb_encode(r.f0) : vec3(0.0);
    } else if (view == VIEW_OCCLUSION) {
        colour = vec3(value.r);
    } else if (view == VIEW_SUN_OCCLUSION) {
        // A layout without that channel hides no surface from the sun.
        colour = vec3(!surface ? 0.0 : gbuffer_layout == GBUFFER_KILLZONE2 ? value.a : 1.0);
#ifdef LIGHT_PAIR
    } else if (view == VIEW_EDGES) {
        colour = vec3(float(surfaces_of(bits.r)) / 4.0);
#endif
    } else if (view == VIEW_COUNT) {
        colour = heat(value.g);
    } else if (view == VIEW_LAYERS) {
        colour = heat(value.r);
    } else {
        colour = srgb_encode(value.rgb);
    }
    out_colour = vec4(colour, 1.0);
}
