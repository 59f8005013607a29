// How soft blended surfaces end before what is opaque behind them. Included where SOFT is defined.
#ifndef PRELIGHT_SOFT_GLSL
#define PRELIGHT_SOFT_GLSL
#include "shared/material_set.glsl"
#include "shared/pixel_images.glsl"

layout(set = SET_INPUTS, binding = INPUT_DEPTH_BEHIND) uniform PIXEL_IMAGE depth_behind;

// What is left of its alpha at a view depth: Material::softness.
float share_before_opaque(float z) {
#ifdef SAMPLES // each sample is shaded by itself
    pixel_sample = findLSB(gl_SampleMaskIn[0]);
#endif
    float behind = pixel_read(depth_behind, ivec2(gl_FragCoord.xy)).r; // 0: nothing is there
    return behind > 0.0 ? clamp((view_depth(behind) - z) / material.emissive.w, 0.0, 1.0) : 1.0;
}
#endif
