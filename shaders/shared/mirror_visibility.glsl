#ifndef PRELIGHT_MIRROR_VISIBILITY_GLSL
#define PRELIGHT_MIRROR_VISIBILITY_GLSL
// What is left of a mirror's light where this share of ambient light comes through: Lagarde and de Rousiers, "Moving
// Frostbite to Physically Based Rendering", 2014.
float mirror_visibility(float nv, float visibility, float roughness) {
    return clamp(pow(max(nv + visibility, 1e-6), exp2(-16.0 * roughness - 1.0)) - 1.0 + visibility, 0.0, 1.0);
}
#endif
