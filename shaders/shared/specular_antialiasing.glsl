// Specular anti-aliasing: how far normals spread under a pixel, geometry and normal map alike, makes the surface
// rougher, so that a highlight that is smaller than a pixel does not come and go (Tokuyoshi and Kaplanyan,
// "Improved Geometric Specular Antialiasing", 2019).
#ifndef PRELIGHT_SPECULAR_ANTIALIASING_GLSL
#define PRELIGHT_SPECULAR_ANTIALIASING_GLSL
#include "shared/bindings.h"

layout(constant_id = CONSTANT_SPECULAR_ANTIALIASING) const bool specular_antialiasing = false;

// `n`: unit, the same space for all pixels of a quad. α² is GGX' variance of slopes up to a factor 2, and a pixel's
// footprint a Gaussian of half a pixel; what a silhouette adds is limited.
float antialiased_roughness(float roughness, vec3 n) {
    if (!specular_antialiasing)
        return roughness;
    vec3 across = dFdx(n), down = dFdy(n);
    float variance = 0.25 * (dot(across, across) + dot(down, down));
    float alpha = roughness * roughness;
    return sqrt(sqrt(min(alpha * alpha + min(2.0 * variance, 0.18), 1.0)));
}
#endif
