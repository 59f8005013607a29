#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
// Tone mapping and sRGB encoding.
#include "shared/display.glsl"

layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform texture2D colour_buffer;
layout(location = 0) out vec4 out_colour;

void main() { out_colour = stored_colour(texelFetch(colour_buffer, ivec2(gl_FragCoord.xy), 0).rgb); }
