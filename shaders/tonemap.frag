#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
// [E4] tone mapping and sRGB encoding.
#include "shared/bindings.h"
#include "shared/display.glsl"

layout(constant_id = CONSTANT_TONEMAP) const int curve = TONEMAP_PBR_NEUTRAL;
layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform texture2D colour_buffer;
layout(location = 0) out vec4 out_colour;

void main() {
    vec3 colour = texelFetch(colour_buffer, ivec2(gl_FragCoord.xy), 0).rgb;
    if (curve == TONEMAP_PBR_NEUTRAL)
        colour = tonemap_pbr_neutral(colour);
    else if (curve == TONEMAP_ACES)
        colour = tonemap_aces(colour);
    out_colour = vec4(srgb_encode(colour), 1.0);
}
