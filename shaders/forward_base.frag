#version 460
#extension GL_GOOGLE_include_directive : require
// variants: OWN_MATERIAL, DECALS, SAMPLES
// only: SAMPLES with DECALS
// materials: all with OWN_MATERIAL
// Multi-pass forward's first pass: ambient and emissive light, or the base colour for --view albedo.
#include "shared/base_light.glsl"

layout(constant_id = CONSTANT_MATERIAL_OUTPUT) const int material_output = MATERIAL_OUTPUT_SHADED;
layout(location = 0) out vec4 out_colour;

void main() {
    Point p = point();
    Surface s = surface_under_decals(p);
    if (is_masked(s))
        discard;
    vec3 colour = material_output == MATERIAL_OUTPUT_ALBEDO ? s.base : base_light(p, s);
    // Half of what a half float holds; the other half is for the lights that are added.
    out_colour = vec4(min(colour, vec3(32752.0)), 1.0);
}
