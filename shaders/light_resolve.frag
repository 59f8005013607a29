#version 460
#extension GL_GOOGLE_include_directive : require
// Deferred shading: accumulated light (RT0) → scene-linear light, or the picture.
#include "shared/display.glsl"
#include "shared/gbuffer_layout.glsl"
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_CLIPPED_LIGHT) const bool clipped = false; // RT0 holds 0 … 1
layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform PIXEL_IMAGE accumulated;
layout(location = 0) out vec4 out_colour;

void main() {
    vec4 stored = pixel_read(accumulated, ivec2(gl_FragCoord.xy));
    vec3 light = stored.rgb * frame.light_buffer.x;
    // Where RGB is full, intensity still knows how bright the pixel is.
    if (clipped && max(stored.r, max(stored.g, stored.b)) >= 1.0)
        light *= max(1.0, stored.a * INTENSITY_RANGE / luminance(stored.rgb));
    // Blending may have gone past the largest half float.
    out_colour = stored_colour(min(light, vec3(65504.0)));
}
