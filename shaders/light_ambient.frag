#version 460
#extension GL_GOOGLE_include_directive : require
// Ambient light as a light of its own: a full-screen quad that adds to the diffuse sum [V1].
#include "shared/frame.glsl"

layout(constant_id = CONSTANT_SHADING) const int shading = SHADING_GGX;

layout(location = 0) flat in uint in_light;
layout(location = 0) out vec4 out_diffuse;
#ifndef ONE_TARGET
layout(location = 1) out vec4 out_specular;
#endif

void main() {
    // [ggx] divides diffuse light by π: a uniform environment of radiance L gives irradiance π·L.
    float irradiance = shading == SHADING_GGX ? 3.14159265 : 1.0;
    out_diffuse = vec4(frame.ambient.rgb * irradiance / frame.light_buffer.x, 0.0);
#ifndef ONE_TARGET
    out_specular = vec4(0.0);
#endif
}
