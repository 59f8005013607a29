#version 460
#extension GL_GOOGLE_include_directive : require
// The sun occlusion channel of Valient's G-buffer: what of the first directional light with shadow maps comes to the pixel's
// surface. Its light pass then reads one byte, which it has anyway, instead of filtering maps.
#include "shared/gbuffer.glsl"
#include "shared/shadows.glsl"

layout(location = 0) out vec4 out_albedo; // only alpha is written

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 world;
    bool surface = read_position(pixel, world);
    vec3 n = read_normal(pixel), to_sun = lights[uint(frame.sun.y)].position.xyz;
    float nl = clamp(dot(n, to_sun), 0.0, 1.0);
    LightShadow shadow = LightShadow(uint(frame.sun.x), SHADOW_CASCADES, vec3(0.0));
    out_albedo = vec4(unshadowed(shadow, world, n, -to_sun, nl, disc_turn(gl_FragCoord.xy), surface && nl > 0.0));
}
