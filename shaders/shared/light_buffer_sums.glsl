// What the light buffer holds of a pixel's lights [L4]. [ggx]: diffuse = Σ N·L att colour, specular =
// Σ N·L att colour D V; alphas: luminance-weighted (1 − V·H)⁵ of each (model=weighted). [phong]:
// equation 8.5.2. Packed: specular's luminance in alpha.
#ifndef PRELIGHT_LIGHT_BUFFER_SUMS_GLSL
#define PRELIGHT_LIGHT_BUFFER_SUMS_GLSL
#include "shared/lit_pixel.glsl"

layout(location = 0) out vec4 out_diffuse;
#ifndef ONE_TARGET
layout(location = 1) out vec4 out_specular;
#endif

struct LightSums {
    vec4 diffuse, specular;
};

LightSums no_light() { return LightSums(vec4(0.0), vec4(0.0)); }

// True when the light contributes.
bool add_light(inout LightSums sums, LitPixel p, LightData light) {
    LightTerms terms = terms_of(p, light);
    float grazing = 0.0;
    if (shading == SHADING_GGX && model == MODEL_WEIGHTED)
        grazing = schlick_weight(dot(p.v, terms.h));
    sums.diffuse += vec4(terms.diffuse, luminance(terms.diffuse) * grazing);
    sums.specular += vec4(terms.specular, luminance(terms.specular) * grazing);
    return terms.contributes;
}

void write_sums(LightSums sums) {
    vec4 limit = vec4(frame.ambient.w);
    float scale = 1.0 / frame.light_buffer.x;
#ifdef ONE_TARGET
    out_diffuse = min(vec4(sums.diffuse.rgb, luminance(sums.specular.rgb)) * scale, limit);
#else
    out_diffuse = min(sums.diffuse * scale, limit);
    out_specular = min(sums.specular * scale, limit);
#endif
}
#endif
