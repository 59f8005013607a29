#version 460
#extension GL_GOOGLE_include_directive : require
// Deferred shading: the ambient light that the geometry pass laid aside, occluded, added to what is in RT0.
#include "shared/gbuffer.glsl"
#include "shared/mirror_visibility.glsl"

layout(set = SET_INPUTS, binding = INPUT_OCCLUSION) uniform PIXEL_IMAGE visibility_buffer;
layout(set = SET_INPUTS, binding = INPUT_AMBIENT_LIGHT) uniform PIXEL_IMAGE ambient_buffer;
layout(set = SET_INPUTS, binding = INPUT_MIRRORED_LIGHT) uniform PIXEL_IMAGE mirrored_buffer;
layout(location = 0) out vec4 out_light;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 world;
    read_position(pixel, world);
    float visibility = pixel_read(visibility_buffer, pixel).r, nv = clamp(dot(read_normal(pixel), to_viewer(world)), 0.0, 1.0);
    vec4 mirrored = pixel_read(mirrored_buffer, pixel);
    vec3 light = pixel_read(ambient_buffer, pixel).rgb * visibility + mirrored.rgb * mirror_visibility(nv, visibility, mirrored.a);
    vec3 stored = min(light / frame.light_buffer.x, vec3(frame.ambient.w));
    out_light = vec4(stored, luminance(stored) / INTENSITY_RANGE);
}
