// Light that needs no lamp: ambient as a term of the material, and emissive; an unlit surface's colour.
#ifndef PRELIGHT_BASE_LIGHT_GLSL
#define PRELIGHT_BASE_LIGHT_GLSL
#include "shared/material_interface.glsl"

vec3 base_light(Point p, Surface s) {
    if (has(FEATURE_UNLIT))
        return s.base * frame.light_buffer.y;
#ifdef OWN_MATERIAL
    return shade(p, s, light_without_lamps(frame.ambient.rgb * s.occlusion, grazing_at_viewer(p, s)));
#else  // shade() of no light: nothing adds up to this, but a software device would add it up
    Reflectance r = reflectance(s.base, s.metallic);
    return frame.ambient.rgb * s.occlusion * (r.diffuse + r.f0) + s.emissive;
#endif
}
#endif
