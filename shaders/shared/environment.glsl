// Ambient light of a surface: the world's environment map, or where there is none, one radiance from
// everywhere. Part of material_interface.glsl.
#ifndef PRELIGHT_ENVIRONMENT_GLSL
#define PRELIGHT_ENVIRONMENT_GLSL
#include "shared/environment_map.glsl"
#include "shared/mirror_visibility.glsl"

float facing(Point p, Surface s) { return clamp(dot(s.normal, p.to_viewer), 0.0, 1.0); }

// Where a mirror of this roughness looks: a rough one's lobe leans from the reflection towards the normal.
vec3 mirror_direction(Point p, Surface s, float roughness) {
    float alpha = roughness * roughness;
    return normalize(mix(reflect(-p.to_viewer, s.normal), s.normal, clamp(alpha * alpha, 0.0, 1.0)));
}

// Replaces `light`'s ambient members by what the environment sends to the surface.
void add_environment(inout Light light, Point p, Surface s) {
    if (!has(FEATURE_ENVIRONMENT))
        return;
    light.ambient = environment_irradiance(s.normal) * s.occlusion;
    light.openness = s.occlusion;
    light.mirrored = environment_radiance(mirror_direction(p, s, s.roughness), s.roughness) * light.openness;
    light.reflectance = environment_reflectance(s.roughness, facing(p, s));
}

// What nearby surfaces let through of ambient light (docs/ssao.md).
void occlude(inout Light light, Point p, Surface s, float visibility) {
    float mirror = has(FEATURE_ENVIRONMENT) ? mirror_visibility(facing(p, s), visibility, s.roughness) : visibility;
    light.ambient *= visibility;
    light.openness *= mirror;
    light.mirrored *= mirror;
}

// What a surface mirrors of the environment; nothing where there is none.
vec3 environment_on(Light light, vec3 f0) {
    return has(FEATURE_ENVIRONMENT) ? light.mirrored * (f0 * light.reflectance.x + light.reflectance.y) : vec3(0.0);
}

// What a surface of these colours sends on of ambient light.
vec3 ambient_on(Light light, vec3 diffuse_colour, vec3 f0) {
    if (!has(FEATURE_ENVIRONMENT))
        return light.ambient * (diffuse_colour + f0);
    return light.ambient * diffuse_colour + environment_on(light, f0);
}
#endif
