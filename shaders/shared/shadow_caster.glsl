// Alpha of what casts into a shadow map, as its glTF material says it. Beside a light interpolation may end far out of
// a triangle's texture coordinates, where lavapipe's anisotropic filter walks over all texels between (minutes for one
// leaf): coordinates are bounded, and the footprint is as wide as it is long.
#ifndef PRELIGHT_SHADOW_CASTER_GLSL
#define PRELIGHT_SHADOW_CASTER_GLSL
#define NO_WORLD
#define NO_NORMAL
#include "shared/surface.glsl"

float caster_alpha() {
    Point p = point();
    float alpha = material.base_colour.a * p.colour.a;
    if (has(FEATURE_BASE_COLOUR_TEXTURE)) {
        vec2 place = clamp(coordinates(p, MATERIAL_BASE_COLOUR), -4096.0, 4096.0), size = vec2(textureSize(base_colour_map, 0));
        float texels = abs(determinant(mat2(dFdx(place) * size, dFdy(place) * size)));
        vec2 side = sqrt(clamp(texels, 1.0, 1e8)) / size;
        alpha *= textureGrad(base_colour_map, place, vec2(side.x, 0.0), vec2(0.0, side.y)).a;
    }
    return alpha;
}
#endif
