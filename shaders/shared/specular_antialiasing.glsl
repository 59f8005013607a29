// Specular anti-aliasing: how far normals spread under a pixel, geometry and normal map alike, makes the surface
// rougher, so that a highlight that is smaller than a pixel does not come and go (Tokuyoshi and Kaplanyan,
// "Improved Geometric Specular Antialiasing", 2019).
#ifndef PRELIGHT_SPECULAR_ANTIALIASING_GLSL
#define PRELIGHT_SPECULAR_ANTIALIASING_GLSL
#include "shared/material_interface.glsl"

layout(constant_id = CONSTANT_SPECULAR_ANTIALIASING) const bool specular_antialiasing = false;

// The roughness that lights see; to be called where all pixels of a quad are still there. α² is twice the variance of
// slopes, of the surface without its decals; a pixel's footprint is a Gaussian of half a pixel; what a silhouette adds is limited.
float antialiased_roughness(Point p, Surface s) {
    if (!specular_antialiasing)
        return s.roughness;
    vec3 across = dFdxFine(bare_normal), down = dFdyFine(bare_normal);
    float spread = min(0.5 * (dot(across, across) + dot(down, down)), 0.18) + 2.0 * normal_map_variance(p);
    float alpha = s.roughness * s.roughness;
    return sqrt(sqrt(min(alpha * alpha + spread, 1.0)));
}
#endif
