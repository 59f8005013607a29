// What the passes of ambient occlusion share. Their images hold visibility (1: open) in x and what is linear on a
// plane over the screen, the reciprocal of view depth or, orthographic, depth itself, in y; 0 where nothing is.
#ifndef PRELIGHT_OCCLUSION_GLSL
#define PRELIGHT_OCCLUSION_GLSL
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_OCCLUSION_RADIUS) const float occlusion_radius = 1.0; // metres
layout(constant_id = CONSTANT_OCCLUSION_SCALE) const int occlusion_scale = 1; // 2: of each 2×2 pixels the first

float plane_depth(float z) { return frame.forward.w > 0.5 ? 1.0 / z : z; }
float view_depth_of(float plane) { return frame.forward.w > 0.5 ? 1.0 / plane : plane; }
#endif
