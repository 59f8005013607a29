#version 460
#extension GL_GOOGLE_include_directive : require
// A finished buffer into an image of the program that Prelight is part of. Of the image that is read and the one that is
// written at most one encodes by itself what it stores.
#include "shared/display.glsl"
#include "shared/pixel_reads.glsl"

layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform PIXEL_IMAGE colour_buffer;
layout(constant_id = CONSTANT_TARGET_CONVERSION) const int conversion = TARGET_AS_IT_IS;
layout(location = 0) out vec4 out_colour;

void main() {
    vec3 colour = pixel_read(colour_buffer, ivec2(gl_FragCoord.xy)).rgb;
    if (conversion == TARGET_ENCODE)
        colour = srgb_encode(colour);
    if (conversion == TARGET_DECODE)
        colour = srgb_decode(colour);
    out_colour = vec4(colour, 1.0);
}
