// The world's environment map as materials see it; where there is none, ambient light.
#ifndef PRELIGHT_ENVIRONMENT_GLSL
#define PRELIGHT_ENVIRONMENT_GLSL
#include "shared/material_interface.glsl"

layout(set = SET_MATERIAL, binding = MATERIAL_ENVIRONMENT) uniform sampler2D environment_map;
layout(set = SET_MATERIAL, binding = MATERIAL_ENVIRONMENT_LIGHT, std140) uniform EnvironmentBlock {
    EnvironmentConstants environment;
};

// Equirectangular: the middle is seen along −Z, the top row towards +Y.
vec2 environment_place(vec3 direction) {
    float longitude = atan(direction.x, -direction.z);
    return vec2(longitude / 6.28318531 + 0.5, acos(clamp(direction.y, -1.0, 1.0)) / 3.14159265);
}

// Radiance that a mirror of this roughness shows in a direction, exposed.
vec3 environment_radiance(vec3 direction, float roughness, Light light) {
    if (!has(FEATURE_ENVIRONMENT))
        return light.ambient;
    return textureLod(environment_map, environment_place(direction), roughness * environment.levels.x).rgb * environment.levels.y;
}

// What a white Lambert surface sends on of it, exposed: Ramamoorthi and Hanrahan 2001.
vec3 environment_ambient(vec3 n, Surface s, Light light) {
    if (!has(FEATURE_ENVIRONMENT))
        return light.ambient;
    vec3 sum = environment.irradiance[0].rgb + environment.irradiance[1].rgb * n.y + environment.irradiance[2].rgb * n.z +
               environment.irradiance[3].rgb * n.x + environment.irradiance[4].rgb * (n.x * n.y) +
               environment.irradiance[5].rgb * (n.y * n.z) + environment.irradiance[6].rgb * (3.0 * n.z * n.z - 1.0) +
               environment.irradiance[7].rgb * (n.x * n.z) + environment.irradiance[8].rgb * (n.x * n.x - n.y * n.y);
    return max(sum, vec3(0.0)) * s.occlusion;
}

// Scale of F0, and what comes on top, of environment light that a rough mirror sends on: Karis, "Physically
// Based Shading on Mobile", 2014.
vec2 environment_reflectance(float roughness, float nv) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a + r.zw;
}
#endif
