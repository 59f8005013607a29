// Set 2: a material's factors and textures.
#ifndef PRELIGHT_MATERIAL_SET_GLSL
#define PRELIGHT_MATERIAL_SET_GLSL
#include "shared/bindings.h"
#include "shared/frame.h"

layout(constant_id = CONSTANT_MATERIAL_FEATURES) const uint material_features = 0u;

layout(set = SET_MATERIAL, binding = MATERIAL_CONSTANTS, std140) uniform MaterialBlock { MaterialConstants material; };
layout(set = SET_MATERIAL, binding = MATERIAL_BASE_COLOUR) uniform sampler2D base_colour_map;
layout(set = SET_MATERIAL, binding = MATERIAL_METALLIC_ROUGHNESS) uniform sampler2D metallic_roughness_map;
layout(set = SET_MATERIAL, binding = MATERIAL_NORMAL) uniform sampler2D normal_map;
layout(set = SET_MATERIAL, binding = MATERIAL_OCCLUSION) uniform sampler2D occlusion_map;
layout(set = SET_MATERIAL, binding = MATERIAL_EMISSIVE) uniform sampler2D emissive_map;

bool has(uint feature) { return (material_features & feature) != 0u; }

// The linear part of KHR_texture_transform, for the texture at a MATERIAL_… binding.
vec2 transformed(int binding, vec2 uv) {
    vec4 m = material.uv_linear[binding - 1];
    return m.xy * uv.x + m.zw * uv.y;
}
#endif
