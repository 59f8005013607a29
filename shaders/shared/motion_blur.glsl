// Motion over the picture while the shutter was open, of surfaces and of what is infinitely far.
#ifndef PRELIGHT_MOTION_BLUR_GLSL
#define PRELIGHT_MOTION_BLUR_GLSL
#include "shared/gbuffer.glsl"

layout(set = SET_INPUTS, binding = INPUT_MATERIAL) uniform PIXEL_IMAGE motion_buffer;  // RT2

// Pixels, right and down positive, at most MOTION_TILE long: what the tiles around a pixel tell of.
vec2 motion_at(ivec2 pixel) {
    vec2 motion = stored_motion(pixel_read(motion_buffer, pixel));
    if (read_depth(pixel) <= 0.0) {  // the background turns with the camera
        vec2 clip = clip_of(vec2(pixel) + 0.5);
        vec3 direction = clip.x * frame.ray_right.xyz + clip.y * frame.ray_up.xyz + frame.forward.xyz;
        vec4 before = frame.previous_clip_from_world * vec4(direction, 0.0);
        motion = before.w > 1e-6 ? (clip - before.xy / before.w) * 0.5 * raster.size.xy : vec2(0.0);
    }
    return motion * min(1.0, float(MOTION_TILE) / max(length(motion), 1e-6));
}
#endif
