#version 460
#extension GL_GOOGLE_include_directive : require
// variants: OWN_MATERIAL, SHADOWS, DECALS|SOFT|LAYER_DECALS, SAMPLES, TRANSMISSION
// never: TRANSMISSION DECALS, TRANSMISSION SOFT, TRANSMISSION LAYER_DECALS
// only: SAMPLES with DECALS|SOFT, TRANSMISSION with OWN_MATERIAL
// materials: all with OWN_MATERIAL, only layered with OWN_MATERIAL TRANSMISSION
// Forward shading of up to eight lights, which come as push constants. Fresnel of each
// light at V·H (model=full), or at N·V (nv). Depth test EQUAL needs no alpha mask, for a hole's depth is another's; LESS_OR_EQUAL
// does.
#include "shared/display.glsl"
#include "shared/forward.h"
#include "shared/forward_light.glsl"

layout(constant_id = CONSTANT_FORWARD_BASE) const bool with_base = false; // ambient and emissive too

layout(early_fragment_tests) in;
layout(push_constant) uniform BatchBlock { ForwardBatch batch; };
layout(location = 0) out vec4 out_colour;

void main() {
    ForwardSurface s = forward_surface();
    if (is_masked(s.surface))
        discard;
    ForwardSums sums = no_lights();
    uint contributing = 0u, count = has(FEATURE_UNLIT) ? 0u : batch.count;
    for (uint i = 0u; i < count; ++i) {
        bool contributes;
        add_light_source(sums, s, light_at(batch.lights[i]), contributes);
        contributing += contributes ? 1u : 0u;
    }
    count_lights(count, contributing);
    if (light_output == LIGHT_OUTPUT_COUNT) {
        out_colour = vec4(float(count), float(contributing), 0.0, 0.0);
        return;
    }
    float alpha = with_base || has(FEATURE_BLENDED) ? blended_coverage(s.surface) : 0.0;
    out_colour = vec4(stored_colour(forward_colour(s, sums, with_base, batch.limit)).rgb, alpha);
#ifdef TRANSMISSION
    out_colour = with_base ? vec4(over_picture(out_colour.rgb, alpha), 1.0) : vec4(out_colour.rgb * blended_coverage(s.surface), 0.0);
#endif
}
