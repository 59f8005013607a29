#version 460
#extension GL_GOOGLE_include_directive : require
// variants: TEXTURED
// The baseline F of measure: a surface's base colour under ambient light, and what it emits, mapped to
// the display at once. No light is looked at.
#include "shared/frame.glsl"
#include "shared/display.glsl"

layout(constant_id = CONSTANT_MATERIAL_FEATURES) const uint material_features = 0u;
layout(set = SET_MATERIAL, binding = MATERIAL_CONSTANTS, std140) uniform MaterialBlock { MaterialConstants material; };
layout(location = 0) in vec4 in_colour;
layout(location = 0) out vec4 out_colour;

bool has(uint feature) { return (material_features & feature) != 0u; }

#ifdef TEXTURED
layout(set = SET_MATERIAL, binding = MATERIAL_BASE_COLOUR) uniform sampler2D base_colour_map;
layout(set = SET_MATERIAL, binding = MATERIAL_EMISSIVE) uniform sampler2D emissive_map;
layout(location = 1) in vec4 in_texcoords;

vec2 coordinates(int binding) {
    vec4 m = material.uv_linear[binding - 1];
    vec4 o = material.uv_offset[binding - 1];
    vec2 uv = o.z > 0.5 ? in_texcoords.zw : in_texcoords.xy;
    return m.xy * uv.x + m.zw * uv.y + o.xy;
}
#endif

void main() {
    vec4 base = material.base_colour * in_colour;
    vec3 emissive = material.emissive.rgb;
#ifdef TEXTURED
    if (has(FEATURE_BASE_COLOUR_TEXTURE))
        base *= texture(base_colour_map, coordinates(MATERIAL_BASE_COLOUR));
    if (has(FEATURE_EMISSIVE_TEXTURE))
        emissive *= texture(emissive_map, coordinates(MATERIAL_EMISSIVE)).rgb;
#endif
    if (has(FEATURE_ALPHA_MASK) && base.a < material.emissive.w)
        discard;
    vec3 colour = has(FEATURE_UNLIT) ? base.rgb * frame.light_buffer.y : base.rgb * frame.ambient.rgb + emissive;
    out_colour = stored_colour(colour);
}
