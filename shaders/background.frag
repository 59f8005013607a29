#version 460
#extension GL_GOOGLE_include_directive : require
// The environment behind everything: drawn at the far end, where the depth test finds nothing.
#include "shared/display.glsl"
#include "shared/environment_map.glsl"
#include "shared/pixel_reads.glsl"

layout(early_fragment_tests) in;
layout(set = SET_MATERIAL, binding = MATERIAL_SKY) uniform sampler2D sky_map;
layout(location = 0) out vec4 out_colour;

void main() {
    vec2 clip = clip_of(gl_FragCoord.xy);
    vec3 across = clip.x * frame.ray_right.xyz + clip.y * frame.ray_up.xyz;
    vec3 direction = normalize(across * frame.forward.w + frame.forward.xyz); // orthographic: all alike
    vec3 radiance = textureLod(sky_map, environment_place(direction), 0.0).rgb * environment.levels.y;
    out_colour = stored_colour(min(radiance, vec3(65504.0)));
}
