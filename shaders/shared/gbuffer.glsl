// Depth and normals read back: position from depth by frustum ray or by inverse matrix, normals
// by their encoding.
#ifndef PRELIGHT_GBUFFER_GLSL
#define PRELIGHT_GBUFFER_GLSL
#include "shared/frame.glsl"
#include "shared/gbuffer_layout.glsl"
#include "shared/linear_depth.h"
#include "shared/normal_encoding.h"
#include "shared/pixel_reads.glsl"

layout(constant_id = CONSTANT_NORMAL_ENCODING) const int normal_encoding = NORMAL_OCT24;
layout(constant_id = CONSTANT_NORMAL_SPACE) const bool view_space = false;
layout(constant_id = CONSTANT_DEPTH_SOURCE) const int depth_source = DEPTH_ATTACHMENT;
layout(constant_id = CONSTANT_POSITION_FROM_RAY) const bool position_from_ray = true;

layout(set = SET_INPUTS, binding = INPUT_DEPTH) uniform PIXEL_IMAGE depth_buffer;
layout(set = SET_INPUTS, binding = INPUT_NORMAL) uniform PIXEL_IMAGE normal_buffer;
#ifdef STENCIL_ROUGHNESS  // as a code of eight bits
layout(set = SET_INPUTS, binding = INPUT_ROUGHNESS) uniform PIXEL_IMAGE_BITS roughness_buffer;
#else
layout(set = SET_INPUTS, binding = INPUT_ROUGHNESS) uniform PIXEL_IMAGE roughness_buffer;
#endif

vec3 stored_normal(vec4 texel) {
    vec3 n = normal_decode(normal_encoding, texel);
    return view_space ? n * mat3(frame.view_from_world) : n;
}

vec3 read_normal(ivec2 pixel) { return stored_normal(pixel_read(normal_buffer, pixel)); }

float read_roughness(ivec2 pixel) {
#ifdef STENCIL_ROUGHNESS
    return roughness_decode(float(pixel_read(roughness_buffer, pixel).r) / 255.0);
#else
    if (gbuffer_layout == GBUFFER_KILLZONE2)
        return roughness_decode(pixel_read(roughness_buffer, pixel).b);
    return normal_holds_roughness(normal_encoding) ? roughness_decode(pixel_read(normal_buffer, pixel).a)
                                                   : pixel_read(roughness_buffer, pixel).r;
#endif
}

// Stored depth is reversed device depth, or view depth (linear_depth); 0 where no surface is.
const bool linear_depth = depth_source != DEPTH_ATTACHMENT;
float read_depth(ivec2 pixel) {
#ifdef SAMPLES // device depth, which is linear over a triangle
    if (shared_samples != 0u) {
        float sum = 0.0;
        for (int i = 0; i < samples; ++i)
            sum += (shared_samples >> i & 1u) != 0u ? texelFetch(depth_buffer, pixel, i).r : 0.0;
        return sum / float(bitCount(shared_samples));
    }
#endif
    return linear_depth_decode(depth_source, pixel_read(depth_buffer, pixel));
}

// Of a surface at a place in pixels; `stored`: as read_depth() has it, 0 where there is none.
vec3 position_of(vec2 place, float stored) {
    bool surface = stored > 0.0;
    vec2 clip = clip_of(place);
    if (position_from_ray) {
        float z = !surface ? 1.0 : linear_depth ? stored : view_depth(stored);
        vec3 across = clip.x * frame.ray_right.xyz + clip.y * frame.ray_up.xyz;
        return across * mix(1.0, z, frame.forward.w) + frame.forward.xyz * z;
    }
    float d = !surface ? 1.0 : linear_depth ? device_depth(stored) : stored;
    vec4 h = frame.world_from_clip * vec4(clip, d, 1.0);
    return h.xyz / h.w;
}

// False where no surface is.
bool read_position(ivec2 pixel, out vec3 world) {
    float stored = read_depth(pixel);
    world = position_of(place_of(pixel), stored);
    return stored > 0.0;
}
#endif
