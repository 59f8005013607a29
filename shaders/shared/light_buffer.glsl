// The light buffer as a material sees it.
#ifndef PRELIGHT_LIGHT_BUFFER_GLSL
#define PRELIGHT_LIGHT_BUFFER_GLSL
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/frame.glsl"

layout(constant_id = CONSTANT_PACKED_LIGHT) const bool packed_light = false;
layout(set = SET_INPUTS, binding = INPUT_DIFFUSE_LIGHT) uniform texture2D diffuse_light;
layout(set = SET_INPUTS, binding = INPUT_SPECULAR_LIGHT) uniform texture2D specular_light;

struct Light {
    vec4 diffuse;   // rgb: Σ diffuse light; a: its weighted grazing term
    vec4 specular;  // rgb: Σ specular light; a: its weighted grazing term
};

Light read_light() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    // Blending may have gone past the largest half float.
    vec4 first = min(texelFetch(diffuse_light, pixel, 0) * frame.light_buffer.x, vec4(65504.0));
    if (packed_light)
        return Light(vec4(first.rgb, 0.0), vec4(first.aaa, 0.0));
    vec4 second = min(texelFetch(specular_light, pixel, 0) * frame.light_buffer.x, vec4(65504.0));
    return Light(first, second);
}

// Mean (1 − V·H)⁵ of the lights on this pixel, weighted by their luminance; 0 without light.
float mean_grazing(vec4 light) { return clamp(light.a / max(luminance(light.rgb), 1e-12), 0.0, 1.0); }
#endif
