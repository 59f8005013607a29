// What no light source sends: ambient as a term of the material, and emissive; an unlit surface's colour.
#ifndef PRELIGHT_BASE_LIGHT_GLSL
#define PRELIGHT_BASE_LIGHT_GLSL
#include "shared/material_interface.glsl"

vec3 base_light(Point p, Surface s) {
    if (has(FEATURE_UNLIT))
        return s.base * frame.light_buffer.y;
#ifdef OWN_MATERIAL
    Light light = light_of_ambient_alone(frame.ambient.rgb * s.occlusion, grazing_at_viewer(p, s));
    add_environment(light, p, s);
    return shade(p, s, light);
#else  // shade() of no light: nothing adds up to this, but a software device would add it up
    Reflectance r = reflectance(s.base, s.metallic);
    if (has(FEATURE_ENVIRONMENT)) {
        Light light = light_of_ambient_alone(vec3(0.0), 0.0);
        add_environment(light, p, s);
        return ambient_on(light, r.diffuse, r.f0) + s.emissive;
    }
    return frame.ambient.rgb * s.occlusion * (r.diffuse + r.f0) + s.emissive;
#endif
}

#ifdef OCCLUSION
// The same in parts, for what is occluded later: `own`, emissive light; what comes from everywhere; and what an
// environment is mirrored as.
struct BaseLight {
    vec3 own, ambient, mirrored;
};

BaseLight base_light_in_parts(Point p, Surface s) {
    if (has(FEATURE_UNLIT))
        return BaseLight(s.base * frame.light_buffer.y, vec3(0.0), vec3(0.0));
    Light light = light_of_ambient_alone(frame.ambient.rgb * s.occlusion, grazing_at_viewer(p, s));
    add_environment(light, p, s);
    Light dark = light, around = light;
    dark.ambient = dark.mirrored = vec3(0.0);
    dark.openness = 0.0;
#ifdef OWN_MATERIAL
    vec3 own = shade(p, s, dark);
    if (!has(FEATURE_ENVIRONMENT))
        return BaseLight(own, shade(p, s, light) - own, vec3(0.0));
    around.mirrored = vec3(0.0);
    around.openness = 0.0;
    vec3 ambient = shade(p, s, around);
    return BaseLight(own, ambient - own, shade(p, s, light) - ambient);
#else
    Reflectance r = reflectance(s.base, s.metallic);
    if (!has(FEATURE_ENVIRONMENT))
        return BaseLight(s.emissive, ambient_on(light, r.diffuse, r.f0), vec3(0.0));
    return BaseLight(s.emissive, light.ambient * r.diffuse, environment_on(light, r.f0));
#endif
}
#endif
#endif
