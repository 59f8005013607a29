// Set 0: what every pass of a frame may read.
#ifndef PRELIGHT_FRAME_GLSL
#define PRELIGHT_FRAME_GLSL
#include "shared/bindings.h"
#include "shared/frame.h"

layout(set = SET_FRAME, binding = FRAME_CONSTANTS, std140) uniform FrameBlock { FrameConstants frame; };
layout(set = SET_FRAME, binding = FRAME_LIGHTS, std430) readonly buffer LightBlock { LightData lights[]; };
layout(set = SET_FRAME, binding = FRAME_LIGHT_ORDER, std430) readonly buffer OrderBlock { uint light_order[]; };
layout(set = SET_FRAME, binding = FRAME_LIGHT_BOUNDS, std430) readonly buffer BoundsBlock { LightScreenBounds light_bounds[]; };

float luminance(vec3 colour) { return dot(colour, vec3(0.2126, 0.7152, 0.0722)); }

// Unit vector from a world position to the viewer; all parallel for an orthographic camera.
vec3 to_viewer(vec3 world) { return normalize(mix(-frame.forward.xyz, -world, frame.forward.w)); }
#endif
