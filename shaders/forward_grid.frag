#version 460
#extension GL_GOOGLE_include_directive : require
// variants: OWN_MATERIAL, SHADOWS, DECALS|SOFT|LAYER_DECALS, SAMPLES, WEIGHTED, BEYOND_K_BUFFER, TRANSMISSION
// only: SAMPLES with DECALS|SOFT, TRANSMISSION with OWN_MATERIAL, BEYOND_K_BUFFER with WEIGHTED
// never: WEIGHTED DECALS, TRANSMISSION DECALS, TRANSMISSION SOFT, TRANSMISSION LAYER_DECALS, TRANSMISSION WEIGHTED
// materials: all with OWN_MATERIAL, only layered with OWN_MATERIAL TRANSMISSION
// Forward shading with the lights of the pixel's cell in a grid over the world. It needs nothing of
// the screen, so that blended surfaces take the same path; with WEIGHTED they leave sums of colour and weight, and with
// BEYOND_K_BUFFER only what lies behind the layers that slots hold.
#include "shared/blended_weight.h"
#include "shared/display.glsl"
#include "shared/forward_light.glsl"
#include "shared/reaching_lights.glsl"
#ifdef BEYOND_K_BUFFER
#include "shared/k_buffer.glsl"
#endif

layout(constant_id = CONSTANT_FORWARD_BASE) const bool with_base = true; // ambient and emissive too

layout(early_fragment_tests) in;
layout(location = 0) out vec4 out_colour;
#ifdef WEIGHTED
layout(location = 1) out float out_weight;
#endif

uint cell_of(vec3 world) {
    vec3 cell = (world - lists.grid_origin.xyz) / lists.grid_cell.xyz;
    uvec3 at = uvec3(clamp(cell, vec3(0.0), vec3(lists.cells.xyz) - 0.5));
    return (at.z * lists.cells.y + at.y) * lists.cells.x + at.x;
}

// The outer loop is left at its end: a software device runs a body once more for no invocation when the condition
// stands before it.
void add_reaching_lights(inout ForwardSums sums, ForwardSurface s, LightList list, inout uint contributing) {
    EntryRange range = EntryRange(0u, list.everywhere), own = EntryRange(list.first + list.everywhere, list.first + list.count);
    do {
        if (is_empty(range)) {
            range = own;
            own.next = own.end;
        }
        uint first, reaching = reaching_lights(range, first, s.point);
        while (reaching != 0u) {
            uint light = light_entries[first + uint(findLSB(reaching))];
            reaching &= reaching - 1u;
            bool contributes;
            add_light_source(sums, s, light_at(light), contributes);
            contributing += contributes ? 1u : 0u;
        }
    } while (!is_empty(range) || !is_empty(own));
}

void add_all_lights(inout ForwardSums sums, ForwardSurface s, LightList list, inout uint contributing) {
    for (uint i = 0u; i < list.count; ++i) {
        bool contributes;
        add_light_source(sums, s, lights[listed_light(list, i)], contributes);
        contributing += contributes ? 1u : 0u;
    }
}

void main() {
#ifdef BEYOND_K_BUFFER
    if (floatBitsToUint(gl_FragCoord.z) >= k_buffer[first_slot() + slots_of_sample - 1u])
        discard;
#endif
    ForwardSurface s = forward_surface();
    LightList list = list_of(cell_of(in_world), 0u);
    if (has(FEATURE_UNLIT) || blended_coverage(s.surface) == 0.0) // nothing of it shows
        list.count = list.everywhere = 0u;
    ForwardSums sums = no_lights();
    uint contributing = 0u;
    if (lights_as_texels)
        add_reaching_lights(sums, s, list, contributing);
    else
        add_all_lights(sums, s, list, contributing);
    count_lights(list.count, contributing);
    if (light_output == LIGHT_OUTPUT_COUNT) {
        out_colour = vec4(float(list.count), float(contributing), 0.0, 0.0);
        return;
    }
    // Each half of what a half float holds.
    out_colour = vec4(stored_colour(forward_colour(s, sums, with_base, 32752.0)).rgb, blended_coverage(s.surface));
#ifdef TRANSMISSION
    out_colour = vec4(over_picture(out_colour.rgb, out_colour.a), 1.0);
#endif
#ifdef WEIGHTED
    vec3 size = abs(out_colour.rgb);
    out_weight = blended_weight(dot(in_world, frame.forward.xyz), out_colour.a, max(size.r, max(size.g, size.b)));
    out_colour.rgb *= out_weight;
#endif
}
