#version 460
#extension GL_GOOGLE_include_directive : require
// Multi-pass forward's first pass: ambient and emissive light, or the base colour for --view albedo.
#include "shared/surface.glsl"

layout(constant_id = CONSTANT_MATERIAL_OUTPUT) const int material_output = MATERIAL_OUTPUT_SHADED;
layout(location = 0) out vec4 out_colour;

void main() {
    vec4 base = base_colour();
    if (has(FEATURE_ALPHA_MASK) && base.a < material.emissive.w)
        discard;
    vec3 colour = material_output == MATERIAL_OUTPUT_ALBEDO ? base.rgb : base_light(base.rgb);
    // Half of what a half float holds; the other half is for the lights that are added.
    out_colour = vec4(min(colour, vec3(32752.0)), 1.0);
}
