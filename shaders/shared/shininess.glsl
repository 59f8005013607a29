// A glTF material's exponent in [phong].
#ifndef PRELIGHT_SHININESS_GLSL
#define PRELIGHT_SHININESS_GLSL
float shininess(float roughness) {
    float alpha = max(roughness, 0.089) * max(roughness, 0.089);
    return max(2.0 / (alpha * alpha) - 2.0, 0.0);
}
#endif
