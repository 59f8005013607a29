#version 460
#extension GL_GOOGLE_include_directive : require
// What a blended surface leaves of the light: its share multiplies what others leave, and its depth counts where it is
// nearest to the light (largest).
#include "shared/shadow_caster.glsl"

layout(location = 0) out vec4 out_transmittance; // rgb: 1 − alpha; a: depth

void main() {
    float alpha = clamp(caster_alpha(), 0.0, 1.0), depth = gl_FragCoord.z;
    // As maps of opaque casters: for normals that are not the triangle's.
    depth -= max(abs(dFdx(depth)), abs(dFdy(depth)));
    if (alpha == 0.0)
        discard;
    out_transmittance = vec4(vec3(1.0 - alpha), max(depth, 0.0));
}
