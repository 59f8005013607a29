#version 460
#extension GL_GOOGLE_include_directive : require
// Half-resolution visibility for each pixel: of the four around it, bilinear, those that lie at the pixel's depth as far as
// its plane allows.
#include "shared/gbuffer.glsl"
#include "shared/occlusion.glsl"

layout(set = SET_INPUTS, binding = INPUT_OCCLUSION) uniform PIXEL_IMAGE occlusion;
layout(location = 0) out float out_visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), corner = pixel / 2, last = textureSize(occlusion, 0) - 1;
    vec2 part = vec2(pixel - 2 * corner) * 0.5;
    vec3 world;
    bool surface = read_position(pixel, world);
    float z = dot(world, frame.forward.xyz), facing = max(abs(dot(read_normal(pixel), to_viewer(world))), 0.05);
    float tolerance = 0.05 * occlusion_radius + 2.0 * pixel_metres(z) / facing;
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        vec2 there = pixel_read(occlusion, min(corner + step, last)).xy;
        float off = there.y > 0.0 ? abs(view_depth_of(there.y) - z) : 1e9;
        // Where none lies on the plane all count a little: a surface thinner than two pixels has no better.
        float weight = mix(1.0 - part.x, part.x, float(step.x)) * mix(1.0 - part.y, part.y, float(step.y)) *
                       max(clamp(2.0 - off / tolerance, 0.0, 1.0), 1e-4);
        sum += weight * there.x;
        weights += weight;
    }
    out_visibility = surface ? sum / weights : 1.0;
}
