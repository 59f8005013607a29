#version 460
#extension GL_GOOGLE_include_directive : require
// Tone mapping and sRGB encoding.
#include "shared/display.glsl"
#include "shared/pixel_reads.glsl"

layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform PIXEL_IMAGE colour_buffer;
layout(location = 0) out vec4 out_colour;

void main() { out_colour = stored_colour(pixel_read(colour_buffer, ivec2(gl_FragCoord.xy)).rgb); }
