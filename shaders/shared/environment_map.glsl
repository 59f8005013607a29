// The world's environment map, prefiltered level by level for rougher mirrors (src/resident/environment.cpp).
// Only where FEATURE_ENVIRONMENT is set there is one.
#ifndef PRELIGHT_ENVIRONMENT_MAP_GLSL
#define PRELIGHT_ENVIRONMENT_MAP_GLSL
#include "shared/bindings.h"
#include "shared/frame.h"

layout(set = SET_MATERIAL, binding = MATERIAL_ENVIRONMENT) uniform sampler2D environment_map;
layout(set = SET_MATERIAL, binding = MATERIAL_REFLECTANCE) uniform sampler2D reflectance_table;
layout(set = SET_MATERIAL, binding = MATERIAL_ENVIRONMENT_LIGHT, std140) uniform EnvironmentBlock {
    EnvironmentConstants environment;
};

// Equirectangular: the middle is seen along −Z, the top row towards +Y; turned as the environment is.
vec2 environment_place(vec3 direction) {
    float longitude = atan(direction.x, -direction.z);
    return vec2(longitude / 6.28318531 + 0.5 + environment.levels.z, acos(clamp(direction.y, -1.0, 1.0)) / 3.14159265);
}

// One of the roughnesses that the map is prefiltered for: the even ones lie in the upper halves of its levels, the odd ones in
// the lower.
vec3 environment_of_step(vec2 place, float step) {
    float level = floor(0.5 * step), lower = step - 2.0 * level, half_row = 0.5 * exp2(level) / environment.levels.x;
    float v = clamp(place.y, half_row, 1.0 - half_row); // the halves do not mix
    return textureLod(environment_map, vec2(place.x, 0.5 * (v + lower)), level).rgb;
}

// Radiance that a mirror of this roughness shows in a direction, exposed. Steps are 0 and 1/8 · 2^(i/4).
vec3 environment_radiance(vec3 direction, float roughness) {
    float r = clamp(roughness, 0.0, 1.0), step = r < 0.125 ? 8.0 * r : 1.0 + 4.0 * log2(8.0 * r), below = min(floor(step), 12.0);
    vec2 place = environment_place(direction);
    return mix(environment_of_step(place, below), environment_of_step(place, below + 1.0), step - below) * environment.levels.y;
}

// What a white Lambert surface sends on of it, exposed: Ramamoorthi and Hanrahan 2001.
vec3 environment_irradiance(vec3 n) {
    vec3 sum = environment.irradiance[0].rgb + environment.irradiance[1].rgb * n.y + environment.irradiance[2].rgb * n.z +
               environment.irradiance[3].rgb * n.x + environment.irradiance[4].rgb * (n.x * n.y) +
               environment.irradiance[5].rgb * (n.y * n.z) + environment.irradiance[6].rgb * (3.0 * n.z * n.z - 1.0) +
               environment.irradiance[7].rgb * (n.x * n.z) + environment.irradiance[8].rgb * (n.x * n.x - n.y * n.y);
    return max(sum, vec3(0.0));
}

// Scale of F0 and of F90 of environment light that a rough mirror sends on: ∫ D V N·L, split by Schlick's term (Karis,
// "Real Shading in Unreal Engine 4", 2013). The table's outer texels are for 0 and 1.
vec2 environment_reflectance(float roughness, float nv) {
    vec2 size = vec2(textureSize(reflectance_table, 0));
    vec2 place = (vec2(nv, clamp(roughness, 0.0, 1.0)) * (size - 1.0) + 0.5) / size;
    return textureLod(reflectance_table, place, 0.0).rg;
}
#endif
