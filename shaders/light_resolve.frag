#version 460
#extension GL_GOOGLE_include_directive : require
// variants: SAMPLE_LIGHT
// Deferred shading: accumulated light (RT0) → scene-linear light, or the picture.
#include "shared/display.glsl"
#include "shared/gbuffer_layout.glsl"
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_CLIPPED_LIGHT) const bool clipped = false; // RT0 holds 0 … 1
layout(set = SET_INPUTS, binding = INPUT_COLOUR) uniform PIXEL_IMAGE accumulated;
#ifdef SAMPLE_LIGHT // edge pixels' samples have light of their own
#include "shared/edge_samples.glsl"
layout(set = SET_INPUTS, binding = INPUT_EDGE_FLAGS) uniform ONE_SAMPLE_IMAGE_BITS edges;
layout(set = SET_INPUTS, binding = INPUT_SAMPLE_DIFFUSE) uniform ONE_SAMPLE_IMAGE sample_light;
#endif
layout(location = 0) out vec4 out_colour;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 stored = pixel_read(accumulated, pixel);
#ifdef SAMPLE_LIGHT
    uvec4 edge = one_sample_read(edges, pixel);
    if (has_slots(edge)) {
        uint surface = surface_of(edge.r, gl_SampleID);
        ivec2 texel = edge_texel(first_slot(edge) + surface);
        stored = surface < surfaces_of(edge.r) ? one_sample_read(sample_light, texel) : vec4(0.0);
    }
#endif
    vec3 light = stored.rgb * frame.light_buffer.x;
    // Where RGB is full, intensity still knows how bright the pixel is.
    if (clipped && max(stored.r, max(stored.g, stored.b)) >= 1.0)
        light *= max(1.0, stored.a * INTENSITY_RANGE / luminance(stored.rgb));
    // Blending may have gone past the largest half float.
    out_colour = stored_colour(min(light, vec3(65504.0)));
}
