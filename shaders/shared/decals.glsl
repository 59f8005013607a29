// What decals leave of a surface. Included where DECALS is defined: by passes over the objects that decals reach.
#ifndef PRELIGHT_DECALS_GLSL
#define PRELIGHT_DECALS_GLSL
#include "shared/pixel_images.glsl"
#include "shared/surface.glsl"

layout(set = SET_INPUTS, binding = INPUT_DECAL_COLOUR) uniform PIXEL_IMAGE decal_colour;
layout(set = SET_INPUTS, binding = INPUT_DECAL_NORMAL) uniform PIXEL_IMAGE decal_normal;
layout(set = SET_INPUTS, binding = INPUT_DECAL_ROUGHNESS) uniform PIXEL_IMAGE decal_roughness;
layout(set = SET_INPUTS, binding = INPUT_DECAL_METALLIC) uniform PIXEL_IMAGE decal_metallic;

void apply_decals(inout Surface s) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef SAMPLES // whoever reads it shades each sample by itself
    pixel_sample = findLSB(gl_SampleMaskIn[0]);
#endif
    vec4 colour = pixel_read(decal_colour, pixel);
    vec2 roughness = pixel_read(decal_roughness, pixel).rg;
    s.base = s.base * colour.a + colour.rgb;
    s.metallic = s.metallic * colour.a + pixel_read(decal_metallic, pixel).r;
    s.roughness = s.roughness * roughness.g + roughness.r;
#ifndef NO_NORMAL
    vec4 normal = pixel_read(decal_normal, pixel);
    if (normal.a < 1.0)
        s.normal = normalize(s.normal * normal.a + normal.rgb);
#endif
}
#endif
