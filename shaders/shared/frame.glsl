// Set 0: what every pass of a frame may read.
#ifndef PRELIGHT_FRAME_GLSL
#define PRELIGHT_FRAME_GLSL
#include "shared/bindings.h"
#include "shared/frame.h"

layout(set = SET_FRAME, binding = FRAME_CONSTANTS, std140) uniform FrameBlock { FrameConstants frame; };
layout(set = SET_FRAME, binding = FRAME_LIGHTS, std430) readonly buffer LightBlock { LightData lights[]; };
layout(set = SET_FRAME, binding = FRAME_LIGHT_ORDER, std430) readonly buffer OrderBlock { uint light_order[]; };
layout(set = SET_FRAME, binding = FRAME_LIGHT_BOUNDS, std430) readonly buffer BoundsBlock { LightScreenBounds light_bounds[]; };

// The same as `lights`, four texels a light: a software device fetches a texel for all lanes at once, and loads from a
// storage buffer lane by lane.
layout(set = SET_FRAME, binding = FRAME_LIGHT_TEXELS) uniform samplerBuffer light_texels;
layout(constant_id = CONSTANT_LIGHTS_AS_TEXELS) const bool lights_as_texels = false;

// xyz: LightData's position; w: its inverse_range.
vec4 fetched_sphere(uint light) { return texelFetch(light_texels, int(4u * light)); }

LightData light_at(uint light) {
    if (!lights_as_texels)
        return lights[light];
    int at = int(4u * light);
    vec4 sphere = fetched_sphere(light), colour = texelFetch(light_texels, at + 1), axis = texelFetch(light_texels, at + 2),
         cone = texelFetch(light_texels, at + 3);
    return LightData(sphere.xyz, sphere.w, colour.rgb, floatBitsToUint(colour.w), axis.xyz, axis.w, cone.xy, cone.z,
                     floatBitsToUint(cone.w));
}

float luminance(vec3 colour) { return dot(colour, vec3(0.2126, 0.7152, 0.0722)); }

// Unit vector from a world position to the viewer; all parallel for an orthographic camera.
vec3 to_viewer(vec3 world) { return normalize(mix(-frame.forward.xyz, -world, frame.forward.w)); }

// Device depth (1 near, 0 far) → view depth in metres. clip.z = −x·z + y, clip.w = z or 1.
float view_depth(float device_depth) {
    float perspective = frame.forward.w;
    return perspective > 0.5 ? frame.depth.y / (device_depth + frame.depth.x)
                             : (frame.depth.y - device_depth) / frame.depth.x;
}

float device_depth(float z) {
    return (frame.depth.y - frame.depth.x * z) / (frame.forward.w > 0.5 ? z : 1.0);
}
#endif
