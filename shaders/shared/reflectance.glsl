// What a surface reflects, from the two numbers that glTF gives.
#ifndef PRELIGHT_REFLECTANCE_GLSL
#define PRELIGHT_REFLECTANCE_GLSL

struct Reflectance {
    vec3 diffuse;
    vec3 f0;  // at normal incidence
};

Reflectance reflectance(vec3 base, float metallic) {
    return Reflectance(base * (1.0 - metallic), mix(vec3(0.04), base, metallic));
}
#endif
