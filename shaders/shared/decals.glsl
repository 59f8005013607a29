// What decals leave of a surface. Included where DECALS is defined: by passes over the objects that decals reach.
#ifndef PRELIGHT_DECALS_GLSL
#define PRELIGHT_DECALS_GLSL
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/surface.glsl"

layout(set = SET_INPUTS, binding = INPUT_DECAL_COLOUR) uniform texture2D decal_colour;
layout(set = SET_INPUTS, binding = INPUT_DECAL_NORMAL) uniform texture2D decal_normal;
layout(set = SET_INPUTS, binding = INPUT_DECAL_ROUGHNESS) uniform texture2D decal_roughness;
layout(set = SET_INPUTS, binding = INPUT_DECAL_METALLIC) uniform texture2D decal_metallic;

void apply_decals(inout Surface s) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(decal_colour, pixel, 0);
    vec2 roughness = texelFetch(decal_roughness, pixel, 0).rg;
    s.base = s.base * colour.a + colour.rgb;
    s.metallic = s.metallic * colour.a + texelFetch(decal_metallic, pixel, 0).r;
    s.roughness = s.roughness * roughness.g + roughness.r;
#ifndef NO_NORMAL
    vec4 normal = texelFetch(decal_normal, pixel, 0);
    if (normal.a < 1.0)
        s.normal = normalize(s.normal * normal.a + normal.rgb);
#endif
}
#endif
